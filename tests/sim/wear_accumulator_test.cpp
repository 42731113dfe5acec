// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear distributed under constant load, against the closed form, and the volume of both rules.
#include "gudgeon/sim/wear_accumulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "gudgeon/sim/tsitouras.h"
#include "tests/sim/worn_contact.h"

namespace gudgeon {
namespace {

class Cells : public testing::TestWithParam<std::tuple<int, PressureDistribution>> {
 protected:
  static int n_cells() { return std::get<0>(GetParam()); }
  static PressureDistribution pressure() { return std::get<1>(GetParam()); }
};

// Load W turns once around at constant slip: every cell wears the same, h = k_d W s/(2 π R w).
TEST_P(Cells, ConstantLoadWearsEvenly) {
  Contact contact = make_worn_contact();
  contact.pressure = pressure();
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, n_cells());
  const int n_steps = 2 * n_cells();  // so that arcs begin at every cell's edges alike
  for (int k = 0; k < n_steps; ++k)
    accumulator.add(make_worn_sample(2.0 * std::numbers::pi * k / n_steps), 1.0 / n_steps);
  const JointWear wear = accumulator.summarize("J");
  const double expected = 0.75 * kCoefficient * 640.0 * 0.31 / (2.0 * std::numbers::pi * 15e-3 * 20e-3);
  for (const double depth : wear.bearing_depth_added) EXPECT_NEAR(depth / expected, 1.0, 1e-9);
  EXPECT_NEAR(wear.sliding_distance, 0.31, 1e-12);
  EXPECT_NEAR(wear.impulse, 640.0, 1e-9);
}

// Whatever the cells and the pressure, the volume is k_d F s to rounding; bearing and journal share it as their
// coefficients.
TEST_P(Cells, SpreadConservesVolume) {
  Contact contact = make_worn_contact();
  contact.pressure = pressure();
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, n_cells(), 20000.0);
  for (int k = 0; k < 500; ++k) {
    ContactSample sample = make_worn_sample(0.37 * k * k);
    sample.bearing_angle = 0.9 * k;
    sample.journal_angle = -1.7 * k;
    sample.penetration *= 1.0 + k % 7;
    accumulator.add(sample, 1e-3);
  }
  const JointWear wear = accumulator.summarize("J");
  const double archard = kCoefficient * 640.0 * 0.31 * 0.5 * 20000.0;
  EXPECT_NEAR(wear.archard_volume / archard, 1.0, 1e-12);
  EXPECT_NEAR(wear.removed_volume / archard, 1.0, 1e-11);  // sums of thousands of parts
}

INSTANTIATE_TEST_SUITE_P(Of, Cells,
                         testing::Combine(testing::Values(100, 1000, 4000),
                                          testing::Values(PressureDistribution::uniform,
                                                          PressureDistribution::parabolic)));

// A contact that stays: 3/2 of the uniform depth at the middle of the arc, none at its ends, the same volume.
TEST(ParabolicPressure, WearsAStillArcDeeperAtItsMiddle) {
  const Contact uniform = make_worn_contact();
  Contact parabolic = uniform;
  parabolic.pressure = PressureDistribution::parabolic;
  for (const WearDistribution distribution : {WearDistribution::spread, WearDistribution::point}) {
    WearAccumulator a(std::span(&uniform, 1), distribution, 40000);
    WearAccumulator b(std::span(&parabolic, 1), distribution, 40000);
    for (WearAccumulator* accumulator : {&a, &b}) accumulator->add(make_worn_sample(1.0), 1.0);
    const JointWear flat = a.summarize("J");
    const JointWear round = b.summarize("J");
    const double ratio = std::ranges::max(round.bearing_depth_added) / std::ranges::max(flat.bearing_depth_added);
    // A cell is a thousandth of the arc: its mean is less than the peak by some 1e-6.
    EXPECT_NEAR(ratio, 1.5, distribution == WearDistribution::spread ? 3e-6 : 1e-15);
    EXPECT_DOUBLE_EQ(flat.archard_volume, round.archard_volume);
    const double removed = round.removed_volume / flat.removed_volume;
    EXPECT_NEAR(removed, distribution == WearDistribution::spread ? 1.0 : 1.5, 1e-11);
  }
}

// The volume is k_e times the work of friction.
TEST(WearAccumulator, EnergyWearFollowsTheWorkOfFriction) {
  Contact contact = make_worn_contact();
  contact.bearing_wear = EnergyWear{3e-13};
  contact.journal_wear = EnergyWear{1e-13};
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, 1000);
  double work = 0.0;
  for (int k = 0; k < 200; ++k) {
    ContactSample sample = make_worn_sample(0.1 * k);
    sample.slip_speed = std::sin(0.3 * k);
    sample.friction_force = 0.2 * sample.normal_force * std::tanh(20.0 * sample.slip_speed);
    accumulator.add(sample, 1e-3);
    work += 1e-3 * sample.friction_force * sample.slip_speed;
  }
  EXPECT_NEAR(accumulator.summarize("J").removed_volume / (4e-13 * work), 1.0, 1e-11);
}

// At constant load the volume is F [k_∞ s + (k₀ − k_∞) s_r (1 − exp(−s/s_r))]; the distance counts times the wear
// acceleration, and goes on where the stages before left it.
TEST(WearAccumulator, RunsInOverTheAcceleratedDistance) {
  constexpr double kWearAcceleration = 500.0;
  Contact contact = make_worn_contact();
  contact.bearing_wear = RunningInDistance{9e-14, 4e-14, 60.0};
  contact.journal_wear = NoWear{};
  const auto exact = [](double s) { return 640.0 * (4e-14 * s + 5e-14 * 60.0 * (1.0 - std::exp(-s / 60.0))); };
  double slid = 0.0;
  for (int stage = 0; stage < 3; ++stage) {
    contact.sliding_distance = slid;
    WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, 100, kWearAcceleration);
    for (int k = 0; k < 1000; ++k) accumulator.add(make_worn_sample(0.01 * k), 1e-4);
    const JointWear wear = accumulator.summarize("J");
    const double after = slid + kWearAcceleration * wear.sliding_distance;
    EXPECT_NEAR(wear.sliding_distance, 0.031, 1e-14) << "the record's is not accelerated";
    // A midpoint rule: steps of 2.6e-4 s_r are off by their square over 24.
    EXPECT_NEAR(wear.removed_volume / (exact(after) - exact(slid)), 1.0, 1e-8);
    slid = after;
  }
}

// What the explicit pair sees of a contact that slides over a step, its direction turning at a constant rate.
std::vector<WearAccumulator::StepSample> make_step(const std::vector<ContactSample>& contacts, double h) {
  std::vector<WearAccumulator::StepSample> step;
  for (int s = 0; s < Tsitouras::kStages; ++s) {
    step.push_back({&contacts[s], Tsitouras::kNodes[s], Tsitouras::kWeights[s] * h, Tsitouras::kShares[s]});
  }
  return step;
}

std::vector<ContactSample> make_turning_samples(double from, double by) {
  std::vector<ContactSample> contacts;
  for (const double node : Tsitouras::kNodes) contacts.push_back(make_worn_sample(from + node * by));
  return contacts;
}

// The law is asked at the distance slid by each stage's time, not by what its weights add up to: steps of 0.3 s_r are
// still right to what a rule of fifth order makes of an exponential.
TEST(WearAccumulator, RunsInOverTheDistanceWithinAStep) {
  constexpr double kRunIn = 1.0;
  Contact contact = make_worn_contact();
  contact.bearing_wear = RunningInDistance{9e-14, 0.0, kRunIn};
  contact.journal_wear = NoWear{};
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, 100);
  const std::vector<ContactSample> contacts = make_turning_samples(0.3, 0.1);
  accumulator.add(make_step(contacts, 0.3 * kRunIn / 0.31));
  const double exact = 640.0 * 9e-14 * kRunIn * (1.0 - std::exp(-0.3));
  EXPECT_NEAR(accumulator.summarize("J").removed_volume / exact, 1.0, 1e-5);
}

// Negative weights say how much, not where: no cell is given less than nothing, and the volume is k_d F s.
TEST(WearAccumulator, DistributesNothingNegative) {
  const Contact contact = make_worn_contact();
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, 1000);
  constexpr double kDuration = 0.01;
  for (int k = 0; k < 20; ++k) {
    std::vector<ContactSample> contacts = make_turning_samples(0.12 * k, 0.12);
    for (int s = 0; s < Tsitouras::kStages; ++s) contacts[s].penetration *= 1.0 + 0.5 * Tsitouras::kNodes[s];
    accumulator.add(make_step(contacts, kDuration));
  }
  const JointWear wear = accumulator.summarize("J");
  for (const auto* depths : {&wear.bearing_depth_added, &wear.journal_depth_added, &wear.total_depth_added}) {
    // 1e-18 m: rounding of sums of depths of 1e-11 m over a circumference.
    for (const double depth : *depths) EXPECT_GE(depth, -1e-18);
  }
  EXPECT_NEAR(wear.removed_volume / (kCoefficient * 640.0 * 0.31 * 20 * kDuration), 1.0, 1e-11);
  EXPECT_NEAR(wear.sliding_distance, 0.31 * 20 * kDuration, 1e-14);
}

// Where no other stage presses, the one that does tells the place.
TEST(WearAccumulator, FindsAPlaceForAContactThatEnds) {
  const Contact contact = make_worn_contact();
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, 1000);
  std::vector<ContactSample> contacts = make_turning_samples(0.0, 0.12);
  for (const int s : {2, 3, 4, 5, 6}) contacts[s].normal_force = 0.0;
  accumulator.add(make_step(contacts, 0.01));
  const JointWear wear = accumulator.summarize("J");
  EXPECT_GT(wear.removed_volume, 0.0);
  EXPECT_NEAR(wear.removed_volume / wear.archard_volume, 1.0, 1e-11);
}

// The depth before the stage counts, that of the surface it wears.
TEST(WearAccumulator, RunsInOverTheDepthOfEachSurface) {
  Contact contact = make_worn_contact();
  contact.bearing_wear = contact.journal_wear = RunningInDepth{9e-14, 4e-14, 2e-6};
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::point, 100);
  ContactSample sample = make_worn_sample(2.0);
  sample.bearing_depth = 2e-6;
  sample.journal_depth = 6e-6;
  accumulator.add(sample, 1.0);
  const JointWear wear = accumulator.summarize("J");
  const double ratio = std::ranges::max(wear.bearing_depth_added) / std::ranges::max(wear.journal_depth_added);
  EXPECT_NEAR(ratio, (4.0 + 5.0 * std::exp(-1.0)) / (4.0 + 5.0 * std::exp(-3.0)), 1e-14);
}

// The paper's rule: the depth of the whole arc into one cell, so that finer cells lose more volume.
TEST(PointDistribution, GivesOneCellTheWholeDepth) {
  const Contact contact = make_worn_contact();
  WearAccumulator coarse(std::span(&contact, 1), WearDistribution::point, 100);
  WearAccumulator fine(std::span(&contact, 1), WearDistribution::point, 1000);
  for (WearAccumulator* accumulator : {&coarse, &fine}) accumulator->add(make_worn_sample(1.0), 1.0);
  const JointWear a = coarse.summarize("J");
  const JointWear b = fine.summarize("J");
  EXPECT_EQ(std::ranges::count_if(a.total_depth_added, [](double h) { return h > 0.0; }), 1);
  EXPECT_GT(a.total_depth_added[15], 0.0);   // 1 rad is 15.9 cells of 100
  EXPECT_GT(b.total_depth_added[159], 0.0);  // and 159.2 of 1000
  EXPECT_DOUBLE_EQ(a.total_depth_added[15], b.total_depth_added[159]);
  EXPECT_NEAR(a.removed_volume / b.removed_volume, 10.0, 1e-12);
}

TEST(WearAccumulator, LiesWhereTheSurfacesAre) {
  const Contact contact = make_worn_contact();
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::point, 360);
  ContactSample sample = make_worn_sample(2.0);
  sample.bearing_angle = 0.5;
  sample.journal_angle = -1.0;
  accumulator.add(sample, 1.0);
  const JointWear wear = accumulator.summarize("J");
  const auto degrees = [](double radians) { return static_cast<std::size_t>(radians * 180.0 / std::numbers::pi); };
  EXPECT_GT(wear.bearing_depth_added[degrees(1.5)], 0.0);
  EXPECT_GT(wear.journal_depth_added[degrees(3.0)], 0.0);
  EXPECT_NEAR(wear.bearing_depth_added[degrees(1.5)] / wear.journal_depth_added[degrees(3.0)], 3.0, 1e-12);
}

TEST(WearAccumulator, NothingWithoutForce) {
  const Contact contact = make_worn_contact();
  WearAccumulator accumulator(std::span(&contact, 1), WearDistribution::spread, 100);
  ContactSample sample = make_worn_sample(2.0);
  sample.normal_force = 0.0;
  sample.penetration = -1e-6;
  accumulator.add(sample, 1.0);
  EXPECT_EQ(accumulator.summarize("J").archard_volume, 0.0);
}

}  // namespace
}  // namespace gudgeon
