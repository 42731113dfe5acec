// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Published motions of ideal mechanisms: A01 and A02 of the IFToMM benchmark, and a torque-driven slider-crank.
// The reference values have nine digits and the runs are at tight tolerance: both sides are good to 1e-6 and better.
#include <gtest/gtest.h>

#include <algorithm>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

constexpr double kTolerance = 1e-6;

// Runs an ideal mechanism for a number of seconds, one sample a second.
StageRecord run_seconds(const Mechanism& mechanism, int seconds) {
  Study study;
  study.cycle_time = 1.0;
  study.cycles = seconds;
  study.outputs_per_cycle = 1;
  study.relative_tolerance = 1e-11;
  study.absolute_tolerance = 1e-12;
  const auto stages = run_study(mechanism, study);
  EXPECT_EQ(stages.size(), 1U);
  EXPECT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
  return stages[0];
}

double value(const StageRecord& stage, const std::string& channel, std::size_t second) {
  return find_values(stage, channel)->at(second);
}

TEST(BenchmarkMotion, PlanarPendulumA01) {
  const StageRecord stage = run_seconds(oracle::make_point_mass_pendulum(), 10);
  const std::string bob = "bar";
  EXPECT_NEAR(value(stage, bob + ".x", 1), 0.986291751, kTolerance);
  EXPECT_NEAR(value(stage, bob + ".y", 1), -0.165010853, kTolerance);
  EXPECT_NEAR(value(stage, bob + ".x", 5), -0.942305435, kTolerance);
  EXPECT_NEAR(value(stage, bob + ".y", 5), -0.334754338, kTolerance);
  EXPECT_NEAR(value(stage, bob + ".x", 10), -0.275087463, kTolerance);
  EXPECT_NEAR(value(stage, bob + ".y", 10), -0.961419205, kTolerance);
  EXPECT_NEAR(value(stage, bob + ".angle_rate", 10), 4.343160693, kTolerance);
}

TEST(BenchmarkMotion, TwoLoopFourBarA02) {
  const StageRecord stage = run_seconds(oracle::make_n_four_bar(2), 10);
  // The first top joint is the tip of the first vertical bar, whose centre of mass is half-way.
  EXPECT_NEAR(2.0 * value(stage, "post_0.x", 1), -0.195020302, kTolerance);
  EXPECT_NEAR(2.0 * value(stage, "post_0.y", 1), -0.980799206, kTolerance);
  EXPECT_NEAR(2.0 * value(stage, "post_0.x", 5), -0.811310461, kTolerance);
  EXPECT_NEAR(2.0 * value(stage, "post_0.y", 5), -0.584615545, kTolerance);
  EXPECT_NEAR(2.0 * value(stage, "post_0.x", 10), 0.328458112, kTolerance);
  EXPECT_NEAR(2.0 * value(stage, "post_0.y", 10), 0.944518538, kTolerance);
  EXPECT_NEAR(2.0 * value(stage, "post_0.x_velocity", 10), 1.423051470, kTolerance);
  EXPECT_NEAR(2.0 * value(stage, "post_0.y_velocity", 10), -0.494868845, kTolerance);
}

class LoopCount : public testing::TestWithParam<int> {};

// However many loops: one degree of freedom, through the singular position twice a turn. A chain of equal loops moves
// as one bar of the summed inertia would, so energy and the shape of every loop can be told.
TEST_P(LoopCount, KeepsShapeAndEnergyThroughSingularPositions) {
  const int n = GetParam();
  const StageRecord stage = run_seconds(oracle::make_n_four_bar(n), 10);
  double exchanged = 0.0;
  for (const double kinetic : *find_values(stage, "energy.kinetic")) exchanged = std::max(exchanged, kinetic);
  for (const double residual : *find_values(stage, "energy.residual"))
    EXPECT_NEAR(residual, 0.0, kTolerance * exchanged);
  for (std::size_t second = 0; second <= 10; ++second) {
    for (int bar = 1; bar <= n; ++bar) {
      const std::string name = "post_" + std::to_string(bar);
      EXPECT_NEAR(value(stage, name + ".x", second) - bar, value(stage, "post_0.x", second), kTolerance) << name;
      EXPECT_NEAR(value(stage, name + ".y", second), value(stage, "post_0.y", second), kTolerance) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(A02, LoopCount, testing::Values(1, 2, 5));

TEST(BenchmarkMotion, TorqueDrivenSliderCrank) {
  const StageRecord stage = run_seconds(oracle::make_slider_crank_torque(), 2);
  EXPECT_NEAR(value(stage, "crank.angle", 1), 14.127892218, kTolerance);
  EXPECT_NEAR(value(stage, "crank.angle_rate", 1), 20.537482852, kTolerance);
  // This one is printed with seven decimals.
  EXPECT_NEAR(value(stage, "crank.angle", 2), 55.0724438, kTolerance);
  EXPECT_NEAR(value(stage, "crank.angle_rate", 2), 39.7955770, kTolerance);
}

TEST(BenchmarkMotion, IdealSliderCrankAtTheOuterDeadCentre) {
  Study study;
  study.cycles = 1;
  study.outputs_per_cycle = 10;
  const auto stages = run_study(make_ideal(oracle::make_slider_crank_clearance()), study);
  // r ω² (1 + r/l) towards the crank; at time zero nothing but the equations is tested.
  EXPECT_NEAR(find_values(stages[0], "slider.x_acceleration")->front(), -19419.36, 0.01);
}

}  // namespace
}  // namespace gudgeon
