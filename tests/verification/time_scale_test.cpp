// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A mechanism with impacts does the same at every speed, and comes to the truth as its tolerance does.
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"
#include "tests/verification/book/recorder.h"

namespace gudgeon {
namespace {

// Where the slider of Flores' slider-crank stands after one turn [m], by an integration in quadruple precision.
constexpr double kAfterOneTurn = 0.170334499124506;

// The same mechanism, speeded up: forces grow with the square of the speed, and so does the stiffness that gives the
// same penetrations; a speed in a law grows with it.
Mechanism make_fast_slider_crank(double factor) {
  Mechanism mechanism = oracle::make_slider_crank_clearance();
  mechanism.drivers[0].speed *= factor;
  for (Joint& joint : mechanism.joints) {
    auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
    if (clearance == nullptr) continue;
    clearance->contact.bearing_material.young_modulus *= factor * factor;
    clearance->contact.journal_material.young_modulus *= factor * factor;
    clearance->contact.onset_speed_floor *= factor;
  }
  return mechanism;
}

StageRecord run_one_turn(double factor, double tolerance) {
  Study study;
  study.cycle_driver = "motor";
  study.cycles = 1;
  study.outputs_per_cycle = 1;
  study.compare_ideal = false;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-3 * tolerance;
  auto stages = run_study(make_fast_slider_crank(factor), study);
  EXPECT_EQ(stages.size(), 1U);
  EXPECT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
  return std::move(stages[0]);
}

TEST(TimeScale, ImpactsComeToTheTruthAsTheToleranceDoes) {
  book::Recorder recorder({"Motion", "Slider-crank with impacts at 5000 rpm",
                           "an integration in quadruple precision, 15 digits of the slider's place",
                           "A slider-crank with clearance in the slider's joint, no friction, no gravity, one turn.",
                           "impacts magnify errors; at a tolerance of 1e-12 what is left is rounding of the gap"});
  const StageRecord stage = run_one_turn(1.0, 1e-12);
  recorder.verify("x of the slider after one turn [m]", kAfterOneTurn, find_values(stage, "slider.x")->back(), 1e-9);
}

TEST(TimeScale, AMechanismThatIsSpeededUpDoesTheSame) {
  for (const double factor : {10.0, 100.0, 1000.0}) {
    const StageRecord stage = run_one_turn(factor, 1e-12);
    EXPECT_NEAR(find_values(stage, "slider.x")->back(), kAfterOneTurn, 1e-9) << factor;
  }
}

}  // namespace
}  // namespace gudgeon
