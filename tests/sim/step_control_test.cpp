// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The step controller on steps whose error estimate is known.
#include "gudgeon/sim/step_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace gudgeon {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 0.01;

// A step over which nothing moves, with errors as given.
struct StillStep {
  std::vector<double> y;
  std::vector<double> errors;
  double h = kStep;
  double energy_error = 0.0;
  operator AttemptedStep() const { return {h, y, y, errors, energy_error}; }
};

StillStep make_step(std::vector<double> y, std::vector<double> errors, double h = kStep) {
  return {std::move(y), std::move(errors), h, 0.0};
}

Study make_step_study() {
  Study study;
  study.absolute_tolerance = 1e-9;
  study.relative_tolerance = 1e-7;
  return study;
}

// Two components, an angle and a rate, and one that is carried along.
StepControl make_control() {
  static const ErrorTolerance tolerance(make_step_study(), 1, 2);
  return {tolerance, 1e-5};
}

TEST(StepControl, ProposesTheFirstStep) { EXPECT_EQ(make_control().next_step(), 1e-5); }

TEST(StepControl, AcceptsWhatKeepsTheToleranceInTheRootMeanSquare) {
  const double tolerance = 1e-9 + 1e-7 * 0.5;
  // One component alone may use √2 of its tolerance: the mean is over both.
  EXPECT_TRUE(make_control().accepts(make_step({0.5, 0.0, 0.0}, {1.414 * tolerance, 0.0, 0.0})));
  EXPECT_FALSE(make_control().accepts(make_step({0.5, 0.0, 0.0}, {1.415 * tolerance, 0.0, 0.0})));
  EXPECT_TRUE(make_control().accepts(make_step({0.5, 0.0, 0.0}, {0.999 * tolerance, 0.999e-9, 0.0})));
  EXPECT_FALSE(make_control().accepts(make_step({0.5, 0.0, 0.0}, {1.001 * tolerance, 1.001e-9, 0.0})));
}

TEST(StepControl, RejectedStepsShrinkWithinBounds) {
  for (const double error : {1.01e-9, 3e-9, 1e-7, 1e-3, 1e200}) {
    StepControl control = make_control();
    ASSERT_FALSE(control.accepts(make_step({0.0, 0.0, 0.0}, {2.0 * error, 2.0 * error, 0.0}))) << error;
    EXPECT_LE(control.next_step(), 0.9 * kStep) << error;
    EXPECT_GE(control.next_step(), 0.2 * kStep) << error;
  }
}

TEST(StepControl, AcceptedStepsGrowWithinBoundsAndTheMoreTheSmallerTheError) {
  double before = 0.0;
  for (const double share : {1.0, 0.1, 1e-3, 1e-5, 0.0}) {
    StepControl control = make_control();
    ASSERT_TRUE(control.accepts(make_step({0.0, 0.0, 0.0}, {share * 1e-9, share * 1e-9, 0.0})));
    EXPECT_GE(control.next_step(), 0.2 * kStep);
    EXPECT_LE(control.next_step(), 5.0 * kStep);
    EXPECT_GE(control.next_step(), before);
    before = control.next_step();
  }
  EXPECT_DOUBLE_EQ(before, 5.0 * kStep) << "without any error, as far as it is let";
}

TEST(StepControl, ConvergesToTheLengthWhoseErrorJustFits) {
  // An error that goes as h⁵: the controller settles where it stays below the tolerance and above a fifth of it.
  StepControl control = make_control();
  double h = 1e-3;
  double error = 0.0;
  for (int k = 0; k < 60; ++k) {
    error = 1e-9 * std::pow(h / kStep, 5.0);
    control.accepts(make_step({0.0, 0.0, 0.0}, {error, error, 0.0}, h));
    h = control.next_step();
  }
  EXPECT_LT(error, 1e-9);
  EXPECT_GT(error, 0.2e-9);
}

TEST(StepControl, WhatIsNotFiniteIsRejected) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {kNotANumber, infinite, -infinite}) {
    StepControl control = make_control();
    EXPECT_FALSE(control.accepts(make_step({0.0, 0.0, 0.0}, {0.0, bad, 0.0})));
    EXPECT_DOUBLE_EQ(control.next_step(), 0.2 * kStep);
    EXPECT_FALSE(control.accepts(make_step({bad, 0.0, 0.0}, {0.0, 0.0, 0.0}))) << "a state";
    EXPECT_FALSE(control.accepts(make_step({0.0, 0.0, bad}, {0.0, 0.0, 0.0}))) << "carried along";
  }
}

TEST(StepControl, AnAnglesToleranceDoesNotGrowWithItsTurns) {
  // Three tolerances of an angle of 1 rad, or of a rate of 1 rad/s, are far below those of 1000 rad/s.
  const double error = 3.0 * (1e-9 + 1e-7);
  EXPECT_FALSE(make_control().accepts(make_step({1000.0, 0.0, 0.0}, {error, 0.0, 0.0})));
  EXPECT_FALSE(make_control().accepts(make_step({-1000.0, 0.0, 0.0}, {error, 0.0, 0.0})));
  EXPECT_TRUE(make_control().accepts(make_step({0.0, -1000.0, 0.0}, {0.0, error, 0.0})));
}

TEST(StepControl, CarriedComponentsHaveNoTolerance) {
  StepControl control = make_control();
  EXPECT_TRUE(control.accepts(make_step({0.0, 0.0, 1.0}, {0.0, 0.0, 1e6})));
  EXPECT_DOUBLE_EQ(control.next_step(), 5.0 * kStep);
}

// A step whose states are this share of their tolerance off.
StillStep make_energy_step(double share, double energy_error) {
  return {{0.0, 0.0, 0.0}, {share * 1e-9, share * 1e-9, 0.0}, kStep, energy_error};
}

TEST(StepControl, EnergyErrorRejectsWhatKeepsTheTolerance) {
  StepControl control = make_control();
  EXPECT_TRUE(control.accepts(make_energy_step(0.5, 0.99)));
  EXPECT_FALSE(control.accepts(make_energy_step(0.5, 1.01)));
  EXPECT_LE(control.next_step(), 0.9 * kStep);
}

TEST(StepControl, EnergyErrorShortensTheNextStepAsAnErrorOfThatSizeDoes) {
  StepControl by_energy = make_control();
  StepControl by_error = make_control();
  ASSERT_TRUE(by_energy.accepts(make_energy_step(0.2, 0.8)));
  ASSERT_TRUE(by_error.accepts(make_energy_step(0.8, 0.0)));
  EXPECT_NEAR(by_energy.next_step(), by_error.next_step(), 1e-12 * kStep);
  StepControl calm = make_control();
  ASSERT_TRUE(calm.accepts(make_energy_step(0.8, 0.2)));
  EXPECT_NEAR(calm.next_step(), by_error.next_step(), 1e-12 * kStep) << "the larger of both counts";
}

TEST(StepControl, EnergyErrorAsksForNoMoreThanATenthOfTheTolerance) {
  for (const double beyond : {2.0, 1e6, std::numeric_limits<double>::infinity()}) {
    StepControl control = make_control();
    EXPECT_TRUE(control.accepts(make_energy_step(0.099, beyond))) << beyond;
    EXPECT_FALSE(control.accepts(make_energy_step(0.501, beyond))) << beyond;
  }
}

TEST(StepControl, EnergyErrorCannotPassWhatIsNotFinite) {
  for (const double energy_error : {0.0, 1.0, kNotANumber}) {
    StepControl control = make_control();
    EXPECT_FALSE(control.accepts(make_energy_step(kNotANumber, energy_error)));
    EXPECT_DOUBLE_EQ(control.next_step(), 0.2 * kStep);
  }
}

TEST(StepControl, OnsetRecallsTheStepAfterTheLastOne) {
  StepControl control = make_control();
  control.accepts(make_step({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}));
  const double long_step = control.next_step();
  control.note_onset();
  EXPECT_EQ(control.next_step(), long_step) << "nothing to recall yet";
  control.note_step(3e-6);
  control.note_step(7e-4);  // later steps of the contact are not the first
  EXPECT_EQ(control.next_step(), long_step);
  control.note_onset();
  EXPECT_EQ(control.next_step(), 3e-6);
  control.note_step(5e-6);
  control.accepts(make_step({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-7));
  control.note_onset();
  EXPECT_DOUBLE_EQ(control.next_step(), 5e-7) << "what is shorter already stays";
}

}  // namespace
}  // namespace gudgeon
