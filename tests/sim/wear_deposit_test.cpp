// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear laid down under constant load, against the closed form, and the volume of both rules.
#include "gudgeon/sim/wear_deposit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace gudgeon {
namespace {

constexpr double kCoefficient = 8e-14;

Contact make_contact() {
  Contact contact;
  contact.surfaces.bearing_radius = 15e-3;
  contact.surfaces.journal_radius = 14.5e-3;
  contact.width = 20e-3;
  contact.bearing_wear = Archard{0.75 * kCoefficient};
  contact.journal_wear = Archard{0.25 * kCoefficient};
  return contact;
}

// A contact at one direction, with a constant load.
ContactSample make_sample(double direction) {
  ContactSample sample;
  sample.normal = {std::cos(direction), std::sin(direction)};
  sample.bearing_radius = 15e-3;
  sample.journal_radius = 14.5e-3;
  sample.penetration = 7.3e-6;
  sample.normal_force = 640.0;
  sample.slip_speed = -0.31;
  return sample;
}

class Regions : public testing::TestWithParam<int> {};

// Load W turns once around at constant slip: every region wears the same, h = k_d W s/(2 π R w).
TEST_P(Regions, ConstantLoadWearsEvenly) {
  const Contact contact = make_contact();
  WearDeposit deposit(contact, Deposition::spread, GetParam());
  const int n_steps = 2 * GetParam();  // so that arcs begin at every region's edges alike
  for (int k = 0; k < n_steps; ++k) deposit.add(make_sample(2.0 * std::numbers::pi * k / n_steps), 1.0 / n_steps);
  const JointWear wear = deposit.summarize("J", 1.0);
  const double expected = 0.75 * kCoefficient * 640.0 * 0.31 / (2.0 * std::numbers::pi * 15e-3 * 20e-3);
  for (const double depth : wear.bearing_depth_added) EXPECT_NEAR(depth / expected, 1.0, 1e-9);
  EXPECT_NEAR(wear.sliding_distance, 0.31, 1e-12);
  EXPECT_NEAR(wear.impulse, 640.0, 1e-9);
}

// Whatever the regions, the volume is k_d F s to rounding; bearing and journal share it as their coefficients.
TEST_P(Regions, SpreadConservesVolume) {
  const Contact contact = make_contact();
  WearDeposit deposit(contact, Deposition::spread, GetParam());
  for (int k = 0; k < 500; ++k) {
    ContactSample sample = make_sample(0.37 * k * k);
    sample.bearing_angle = 0.9 * k;
    sample.journal_angle = -1.7 * k;
    sample.penetration *= 1.0 + k % 7;
    deposit.add(sample, 1e-3);
  }
  const JointWear wear = deposit.summarize("J", 20000.0);
  const double archard = kCoefficient * 640.0 * 0.31 * 0.5 * 20000.0;
  EXPECT_NEAR(wear.archard_volume / archard, 1.0, 1e-12);
  EXPECT_NEAR(wear.removed_volume / archard, 1.0, 1e-11);  // sums of thousands of parts
}

INSTANTIATE_TEST_SUITE_P(Of, Regions, testing::Values(100, 1000, 4000));

// The paper's rule: the depth of the whole arc into one region, so that finer regions lose more volume.
TEST(PointDeposition, GivesOneRegionTheWholeDepth) {
  const Contact contact = make_contact();
  WearDeposit coarse(contact, Deposition::point, 100);
  WearDeposit fine(contact, Deposition::point, 1000);
  for (WearDeposit* deposit : {&coarse, &fine}) deposit->add(make_sample(1.0), 1.0);
  const JointWear a = coarse.summarize("J", 1.0);
  const JointWear b = fine.summarize("J", 1.0);
  EXPECT_EQ(std::ranges::count_if(a.total_depth_added, [](double h) { return h > 0.0; }), 1);
  EXPECT_GT(a.total_depth_added[15], 0.0);   // 1 rad is 15.9 regions of 100
  EXPECT_GT(b.total_depth_added[159], 0.0);  // and 159.2 of 1000
  EXPECT_DOUBLE_EQ(a.total_depth_added[15], b.total_depth_added[159]);
  EXPECT_NEAR(a.removed_volume / b.removed_volume, 10.0, 1e-12);
}

TEST(WearDeposit, LiesWhereTheSurfacesAre) {
  const Contact contact = make_contact();
  WearDeposit deposit(contact, Deposition::point, 360);
  ContactSample sample = make_sample(2.0);
  sample.bearing_angle = 0.5;
  sample.journal_angle = -1.0;
  deposit.add(sample, 1.0);
  const JointWear wear = deposit.summarize("J", 1.0);
  const auto degrees = [](double radians) { return static_cast<std::size_t>(radians * 180.0 / std::numbers::pi); };
  EXPECT_GT(wear.bearing_depth_added[degrees(1.5)], 0.0);
  EXPECT_GT(wear.journal_depth_added[degrees(3.0)], 0.0);
  EXPECT_NEAR(wear.bearing_depth_added[degrees(1.5)] / wear.journal_depth_added[degrees(3.0)], 3.0, 1e-12);
}

TEST(WearDeposit, NothingWithoutForce) {
  const Contact contact = make_contact();
  WearDeposit deposit(contact, Deposition::spread, 100);
  ContactSample sample = make_sample(2.0);
  sample.normal_force = 0.0;
  sample.penetration = -1e-6;
  deposit.add(sample, 1.0);
  EXPECT_EQ(deposit.summarize("J", 1.0).archard_volume, 0.0);
}

}  // namespace
}  // namespace gudgeon
