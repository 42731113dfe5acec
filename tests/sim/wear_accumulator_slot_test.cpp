// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear along the sides of a slot, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "gudgeon/sim/tsitouras.h"
#include "gudgeon/sim/wear_accumulator.h"
#include "tests/sim/worn_contact.h"

namespace gudgeon {
namespace {

// A corner or a pin in a slot of 600 mm.
Contact make_slot_contact(int side) {
  Contact contact = make_worn_contact();
  contact.surfaces = GuideSurfaces{0.0, side == 0 ? 1.0 : -1.0, 26e-3, 0.3, 5e-3, {}, {}};
  contact.bearing_surface = side;
  return contact;
}

ContactSample make_slot_sample(int side, double position) {
  ContactSample sample = make_worn_sample(side == 0 ? 1.2 : 1.2 - std::numbers::pi);
  sample.bearing_radius = std::numeric_limits<double>::infinity();
  sample.journal_radius = 5e-3;
  sample.bearing_position = position;
  sample.bearing_surface = side;
  return sample;
}

// A load F dragged along a side wears every cell that it passes by h = k_d F/w, however long the contact is.
TEST(SlotWear, ConstantLoadDraggedAlongASideWearsEvenly) {
  for (const PressureDistribution pressure : {PressureDistribution::uniform, PressureDistribution::parabolic}) {
    std::vector<Contact> sides{make_slot_contact(0), make_slot_contact(1)};
    for (Contact& contact : sides) contact.pressure = pressure;
    WearAccumulator accumulator(sides, WearDistribution::spread, 60);
    constexpr double kSlide = 0.02e-3;  // [m], many to the contact of 0.27 mm, an integer number to a cell of 10 mm
    constexpr int kSlides = 20000;      // from -200 to 200 mm
    for (int k = 0; k < kSlides; ++k) {
      const ContactSample sample = make_slot_sample(1, -0.2 + (k + 0.5) * kSlide);
      accumulator.add(sample, kSlide / std::abs(sample.slip_speed));
    }
    const JointWear wear = accumulator.summarize("slot");
    EXPECT_EQ(wear.slot_length, 0.6);
    EXPECT_TRUE(std::isinf(wear.bearing_radius));
    ASSERT_EQ(wear.bearing_depth_added.size(), 120U);
    const double expected = 0.75 * kCoefficient * 640.0 / 20e-3;
    for (std::size_t cell = 0; cell < 120; ++cell) {
      const double share = wear.bearing_depth_added[cell] / expected;
      if (cell < 60) {
        EXPECT_EQ(share, 0.0) << "the left side";
      } else if (cell > 60 + 10 && cell < 60 + 49) {
        EXPECT_NEAR(share, 1.0, 1e-10) << cell;  // sums of some 20000 increments
      } else {
        EXPECT_LE(share, 1.0 + 1e-10);
      }
      EXPECT_NEAR(wear.total_depth_added[cell], 4.0 / 3.0 * wear.bearing_depth_added[cell], 1e-10 * expected);
    }
    // V = k_d F s, whatever was worn off where.
    const double volume = kCoefficient * 640.0 * 0.4;
    EXPECT_NEAR(wear.archard_volume / volume, 1.0, 1e-10);
    EXPECT_NEAR(wear.removed_volume / volume, 1.0, 1e-10);
    EXPECT_NEAR(wear.sliding_distance, 0.4, 1e-12);
  }
}

// The same by steps of the explicit pair that slide by many contacts each, there and back: h = n k_d F/w everywhere the
// contact has passed, and not less than that where steps meet.
TEST(SlotWear, LongStepsWearAsEvenlyAsShortOnes) {
  for (const PressureDistribution pressure : {PressureDistribution::uniform, PressureDistribution::parabolic}) {
    for (const int n_cells : {60, 6000, 100000}) {
      std::vector<Contact> sides{make_slot_contact(0), make_slot_contact(1)};
      for (Contact& contact : sides) contact.pressure = pressure;
      WearAccumulator accumulator(sides, WearDistribution::spread, n_cells);
      constexpr int kSteps = 400;
      constexpr double kStroke = 0.2;
      const auto find_position = [&](double t) { return -kStroke * std::cos(t); };
      for (int k = 0; k < kSteps; ++k) {
        const double h = 2.0 * std::numbers::pi / kSteps;
        std::vector<ContactSample> samples;
        for (const double node : Tsitouras::kNodes) {
          samples.push_back(make_slot_sample(1, find_position((k + node) * h)));
          samples.back().slip_speed = kStroke * std::sin((k + node) * h);
        }
        std::vector<WearAccumulator::StepSample> step;
        for (int s = 0; s < Tsitouras::kStages; ++s) {
          step.push_back({&samples[s], Tsitouras::kNodes[s], Tsitouras::kWeights[s] * h, Tsitouras::kShares[s]});
        }
        accumulator.add(step);
      }
      const JointWear wear = accumulator.summarize("slot");
      const double expected = 2.0 * 0.75 * kCoefficient * 640.0 / 20e-3;
      const double cell = 0.6 / n_cells;
      for (int k = 0; k < n_cells; ++k) {
        const double end = std::abs((k + 0.5) * cell - 0.3) + 0.5 * cell;
        if (end > kStroke - 0.3e-3) continue;  // half a contact of 0.27 mm
        EXPECT_NEAR(wear.bearing_depth_added[n_cells + k] / expected, 1.0, 0.02) << k << " of " << n_cells;
      }
      EXPECT_NEAR(wear.removed_volume / wear.archard_volume, 1.0, 1e-9);
    }
  }
}

TEST(SlotWear, WearsTheLastCellsAtAnEndAndLosesNothing) {
  std::vector<Contact> sides{make_slot_contact(0), make_slot_contact(1)};
  WearAccumulator accumulator(sides, WearDistribution::spread, 6000);
  for (const double end : {-0.3, 0.3}) accumulator.add(make_slot_sample(0, end), 1.0);
  const JointWear wear = accumulator.summarize("slot");
  EXPECT_NEAR(wear.removed_volume / wear.archard_volume, 1.0, 1e-10);
  EXPECT_GT(wear.bearing_depth_added.front(), 0.0);
  // One end at a time: nothing of it comes back at the other.
  WearAccumulator rear(sides, WearDistribution::spread, 6000);
  rear.add(make_slot_sample(0, -0.3), 1.0);
  const JointWear one = rear.summarize("slot");
  EXPECT_NEAR(one.bearing_depth_added[5999], 0.0, 1e-12 * one.bearing_depth_added.front());
  EXPECT_GT(wear.bearing_depth_added[5999], 0.0);
  EXPECT_NEAR(wear.bearing_depth_added[3000], 0.0, 1e-12 * wear.bearing_depth_added.front());  // sums of differences
  EXPECT_EQ(wear.bearing_depth_added[6000], 0.0) << "not around the corner to the other side";
}

TEST(SlotWear, EachCornerWearsWhereItFacesItsSide) {
  std::vector<Contact> corners;
  for (int corner = 0; corner < 4; ++corner) {
    corners.push_back(make_slot_contact(corner / 2));
    corners.back().journal_surface = corner;
  }
  WearAccumulator accumulator(corners, WearDistribution::point, 360);
  ContactSample sample = make_slot_sample(1, 0.1);
  sample.journal_surface = 2;
  sample.journal_angle = 0.3;
  accumulator.add(sample, 1.0);
  const JointWear wear = accumulator.summarize("slot");
  ASSERT_EQ(wear.journal_depth_added.size(), 4U * 360U);
  const auto deepest = std::ranges::max_element(wear.journal_depth_added) - wear.journal_depth_added.begin();
  const double angle = std::remainder(1.2 - std::numbers::pi - 0.3, 2.0 * std::numbers::pi) + 2.0 * std::numbers::pi;
  EXPECT_EQ(deepest, 2 * 360 + static_cast<std::ptrdiff_t>(angle * 180.0 / std::numbers::pi));
  EXPECT_EQ(std::ranges::count_if(wear.journal_depth_added, [](double depth) { return depth > 0.0; }), 1);
}

}  // namespace
}  // namespace gudgeon
