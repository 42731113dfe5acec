// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Peaks of forces and accelerations against closed forms and against runs at a far tighter tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/sim/stage_run.h"
#include "tests/oracle/mechanisms.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

StageRecord run(const Mechanism& mechanism, double relative_tolerance, double cycle_time) {
  Study study;
  study.cycles = 1;
  study.outputs_per_cycle = 20;
  study.relative_tolerance = relative_tolerance;
  study.absolute_tolerance = 1e-3 * relative_tolerance;
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  return StageRun(system, study, cycle_time, "test").run(make_state(system, assembly), {}, {});
}

constexpr double kTurn = 60.0 / 5000.0;  // [s]

// The slider-crank of Flores and Ambrosio over its first turn, solved in quadruple precision.
TEST(PeakDetector, SliderCranksFirstTurnHasItsPeaks) {
  for (const auto& [tolerance, share] : {std::pair{1e-6, 1e-4}, {1e-4, 1e-3}}) {
    const StageRecord stage = run(oracle::make_slider_crank_clearance(), tolerance, kTurn);
    ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
    const auto peak = [&](const char* channel) { return std::abs(find_statistics(stage, channel)->peak()); };
    EXPECT_NEAR(peak("pin.normal_force"), 45872.2, 45872.2 * share) << tolerance;
    EXPECT_NEAR(peak("slider.x_acceleration"), 327339.0, 327339.0 * share) << tolerance;
    const auto& largest = std::ranges::max_element(stage.events, {}, &ContactEvent::peak_force);
    EXPECT_EQ(largest->peak_force, find_statistics(stage, "pin.normal_force")->maximum);
  }
}

TEST(PeakDetector, NoContactsPeakIsLow) {
  const StageRecord exact = run(oracle::make_slider_crank_clearance(), 1e-10, kTurn);
  ASSERT_GE(exact.events.size(), 5U);
  // Errors of the motion grow from contact to contact, at 1e-6 to some percent of the last ones' onset speed: the
  // first, which are the same impacts, are compared.
  for (const auto& [tolerance, n_compared] : {std::pair{1e-4, 5UL}, {1e-5, 10UL}, {1e-6, 20UL}}) {
    const StageRecord stage = run(oracle::make_slider_crank_clearance(), tolerance, kTurn);
    ASSERT_GE(stage.events.size(), n_compared);
    for (std::size_t k = 0; k < n_compared; ++k) {
      EXPECT_GT(stage.events[k].peak_force, 0.995 * exact.events[k].peak_force) << tolerance << ", contact " << k;
      EXPECT_LT(stage.events[k].peak_force, 1.005 * exact.events[k].peak_force) << tolerance << ", contact " << k;
    }
  }
}

// A ball of 2 kg flies into a wall that presses with K d^1.5: ½ m v² = 2/5 K d^2.5. In few steps, as in many.
TEST(PeakDetector, AReboundHasTheForceOfItsEnergy) {
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-9}) {
    const Mechanism mechanism = make_balls({{{0.4, 0.0}, {1.5, 0.0}}}, {}, 1e8);
    const StageRecord stage = run(mechanism, tolerance, 0.15);
    ASSERT_EQ(stage.events.size(), 1U) << tolerance;
    const double stiffness = 4.0 / 3.0 * 0.5e8 * std::sqrt(1.0 * 0.5 / 0.5);  // E* of two such bodies, R_i R_j/c
    const double depth = std::pow(5.0 / 4.0 * 2.0 * 1.5 * 1.5 / stiffness, 0.4);
    const double force = stiffness * depth * std::sqrt(depth);
    EXPECT_NEAR(stage.events[0].peak_force, force, force * std::max(5e-5, tolerance)) << tolerance;
    EXPECT_NEAR(find_statistics(stage, "wall_0.penetration")->maximum, depth, depth * std::max(5e-5, tolerance));
    EXPECT_NEAR(find_statistics(stage, "ball_0.x_acceleration")->peak(), -force / 2.0,
                force / 2.0 * std::max(5e-5, tolerance));
  }
}

// A damper presses most at the first touch, between two steps: d v.
TEST(PeakDetector, AForceThatBeginsWithAStepHasItsPeakThere) {
  Mechanism mechanism = make_balls({{{0.4, 0.0}, {1.5, 0.0}}}, {}, 1e8);
  std::get<RevoluteClearance>(mechanism.joints[0].kind).contact.normal_force = KelvinVoigt{1e3, 400.0};
  const StageRecord stage = run(mechanism, 1e-6, 0.1);
  ASSERT_EQ(stage.events.size(), 1U);
  EXPECT_NEAR(stage.events[0].peak_force, 400.0 * 1.5, 400.0 * 1.5 * 1e-6);
  EXPECT_NEAR(find_statistics(stage, "wall_0.normal_force")->maximum, 600.0, 600.0 * 1e-6);
}

// A point mass of 1 kg that starts level: 3 g at the bottom of its swing, where no step ends.
TEST(PeakDetector, ASwingHasItsPeakBetweenSteps) {
  const StageRecord stage = run(oracle::make_point_mass_pendulum(), 1e-5, 1.5);
  const ChannelStatistics* lift = find_statistics(stage, "bar.y_acceleration");
  ASSERT_NE(lift, nullptr);
  EXPECT_NEAR(lift->maximum, 2.0 * 9.81, 2.0 * 9.81 * 4e-5) << "v²/L = 2 g, upwards";
}

}  // namespace
}  // namespace gudgeon
