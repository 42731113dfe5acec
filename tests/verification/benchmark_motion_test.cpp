// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Published motions of ideal mechanisms: A01 and A02 of the IFToMM benchmark, and a torque-driven slider-crank.
// The reference values have nine digits and the runs are at tight tolerance: both sides are good to 1e-6 and better.
#include <gtest/gtest.h>

#include <algorithm>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"
#include "tests/verification/book/recorder.h"

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

// Nine digits of values up to 4, and what is left of the run's own error.
constexpr double kDigits = 1e-8;
const std::string kReason = "the reference is printed with nine digits, the run's tolerance is 1e-11";

TEST(BenchmarkMotion, PlanarPendulumA01) {
  book::Recorder recorder({"Motion", "A01 planar pendulum", "IFToMM benchmark A01, values to nine digits",
                           "A point mass on a massless bar swings from the horizontal for 10 s.", kReason});
  const StageRecord stage = run_seconds(oracle::make_point_mass_pendulum(), 10);
  recorder.verify("x at 1 s [m]", 0.986291751, value(stage, "bar.x", 1), kDigits);
  recorder.verify("y at 1 s [m]", -0.165010853, value(stage, "bar.y", 1), kDigits);
  recorder.verify("x at 5 s [m]", -0.942305435, value(stage, "bar.x", 5), kDigits);
  recorder.verify("y at 5 s [m]", -0.334754338, value(stage, "bar.y", 5), kDigits);
  recorder.verify("x at 10 s [m]", -0.275087463, value(stage, "bar.x", 10), kDigits);
  recorder.verify("y at 10 s [m]", -0.961419205, value(stage, "bar.y", 10), kDigits);
  recorder.verify("angular velocity at 10 s [rad/s]", 4.343160693, value(stage, "bar.angle_rate", 10), kDigits);
}

TEST(BenchmarkMotion, TwoLoopFourBarA02) {
  book::Recorder recorder({"Motion", "A02 N-four-bar, N = 2", "IFToMM benchmark A02, values to nine digits",
                           "Two loops of equal bars swing for 10 s, through the position where all bars are in line.",
                           kReason});
  const StageRecord stage = run_seconds(oracle::make_n_four_bar(2), 10);
  // The first top joint is the tip of the first vertical bar, whose centre of mass is half-way.
  const auto tip = [&](const char* channel, std::size_t second) {
    return 2.0 * value(stage, std::string("post_0.") + channel, second);
  };
  recorder.verify("x of the first top joint at 1 s [m]", -0.195020302, tip("x", 1), kDigits);
  recorder.verify("y at 1 s [m]", -0.980799206, tip("y", 1), kDigits);
  recorder.verify("x at 5 s [m]", -0.811310461, tip("x", 5), kDigits);
  recorder.verify("y at 5 s [m]", -0.584615545, tip("y", 5), kDigits);
  recorder.verify("x at 10 s [m]", 0.328458112, tip("x", 10), kDigits);
  recorder.verify("y at 10 s [m]", 0.944518538, tip("y", 10), kDigits);
  recorder.verify("x velocity at 10 s [m/s]", 1.423051470, tip("x_velocity", 10), kDigits);
  recorder.verify("y velocity at 10 s [m/s]", -0.494868845, tip("y_velocity", 10), kDigits);
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
  book::Recorder recorder({"Motion", "Torque-driven slider-crank",
                           "published solution of an ideal slider-crank, no gravity",
                           "A constant torque turns the crank up from rest for 2 s.",
                           "the reference is printed with seven decimals at least, the run's tolerance is 1e-11"});
  const StageRecord stage = run_seconds(oracle::make_slider_crank_torque(), 2);
  recorder.verify("crank angle at 1 s [rad]", 14.127892218, value(stage, "crank.angle", 1), kTolerance);
  recorder.verify("crank speed at 1 s [rad/s]", 20.537482852, value(stage, "crank.angle_rate", 1), kTolerance);
  recorder.verify("crank angle at 2 s [rad]", 55.0724438, value(stage, "crank.angle", 2), kTolerance);
  recorder.verify("crank speed at 2 s [rad/s]", 39.7955770, value(stage, "crank.angle_rate", 2), kTolerance);
}

TEST(BenchmarkMotion, IdealSliderCrankAtTheOuterDeadCentre) {
  book::Recorder recorder({"Motion", "Slider-crank of the clearance literature, ideal joints",
                           "closed form r ω² (1 + r/l) at the outer dead centre (Flores, Ambrosio: 5000 rpm)",
                           "The slider's acceleration towards the crank where the mechanism starts.",
                           "the reference is printed with two decimals"});
  Study study;
  study.cycles = 1;
  study.outputs_per_cycle = 10;
  const auto stages = run_study(make_ideal(oracle::make_slider_crank_clearance()), study);
  recorder.verify("slider acceleration [m/s^2]", -19419.36, find_values(stages[0], "slider.x_acceleration")->front(),
                  0.01);
}

}  // namespace
}  // namespace gudgeon
