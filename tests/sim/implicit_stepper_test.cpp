// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Implicit steps of a press whose journals stick, against explicit ones that are short enough.
#include "gudgeon/sim/implicit_stepper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/sim/explicit_stepper.h"
#include "gudgeon/sim/motion_integrator.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

constexpr double kFirstStep = 1e-6;  // [s]

// Stages are solved to a share of the tolerance: here, as well as rounding lets them.
Study make_tight_study() {
  Study study;
  study.relative_tolerance = 1e-10;
  study.absolute_tolerance = 1e-12;
  study.integrator = Integrator::explicit_pair;
  return study;
}

// The nine-bar while one of its journals sticks, before impacts can have made a tolerance felt.
struct Press {
  Press() {
    MotionIntegrator motion(system, tight, 1.0);
    motion.begin(make_state(system, assembly));
    constexpr double kSticks = 0.01083;  // [s]
    while (motion.time() < kSticks) motion.advance(kSticks);
    equations.contact_modes = motion.equations().contact_modes;
    time = motion.time();
    y = motion.y();
    slope.resize(y.size());
    equations.eval(time, y.data(), slope.data());
  }

  Study tight = make_tight_study();
  Mechanism mechanism = oracle::make_nine_bar();
  Assembly assembly = assemble(mechanism);
  System system = compile(mechanism, assembly);
  MotionEquations equations{system, {}};
  double time = 0.0;  // [s]
  std::vector<double> y;
  std::vector<double> slope;
  ErrorTolerance tolerance{tight, static_cast<std::size_t>(system.tables.counts.n_free_turns), 2 * equations.n_free()};
  SolverStatistics statistics;
};

struct SteppedMotion {
  std::vector<double> y;
  std::vector<double> middle;  // by dense output of the last step
};

// Goes on for `duration` in n steps.
template <class Stepper>
SteppedMotion run_steps(double duration, int n) {
  Press press;
  Stepper stepper(press.equations, press.statistics, press.tolerance, kFirstStep);
  std::vector<double> y = press.y;
  std::vector<double> slope = press.slope;
  for (int k = 0; k < n; ++k) {
    stepper.begin(press.time + duration * k / n, y, slope, k > 0);
    stepper.end_at(duration / n);
    stepper.accept();
    y = stepper.end();
    slope = stepper.end_slope();
  }
  SteppedMotion motion{y, std::vector<double>(y.size())};
  stepper.dense().interpolate(0.5, y.size(), motion.middle.data());
  return motion;
}

// Largest difference of coordinates and rates, against their own sizes.
double find_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size() - kEnergyIntegrals; ++i) {
    const double difference = std::abs(a[i] - b[i]) / std::max(std::abs(b[i]), 1e-3);
    if (!(difference <= largest)) largest = difference;  // keeps what is not a number, too
  }
  return largest;
}

constexpr double kSticking = 1e-4;  // [s] over which the journal sticks

TEST(ImplicitStepper, IsTriedWhereAJournalSticks) {
  const Press press;
  double slowest = 1.0;
  for (const ContactForces& forces : press.equations.workspace.contact_forces) {
    if (forces.normal_force > 0.0) slowest = std::min(slowest, std::abs(forces.slip_speed));
  }
  EXPECT_LT(slowest, 1e-4) << "where friction turns";
}

TEST(ImplicitStepper, ConvergesToWhatExplicitStepsConvergeTo) {
  const SteppedMotion exact = run_steps<ExplicitStepper>(kSticking, 1000);
  const auto find_error = [&](int n) { return find_difference(run_steps<ImplicitStepper>(kSticking, n).y, exact.y); };
  // Of the order 5 friction leaves what stages of order 2 have where it is stiff: at least 3.
  EXPECT_LT(find_error(12), 1e-6);
  EXPECT_LT(find_error(24), find_error(12) / 6.0);
  EXPECT_LT(find_error(48), find_error(24) / 6.0);
}

TEST(ImplicitStepper, CarriesIntegralsAlong) {
  const SteppedMotion exact = run_steps<ExplicitStepper>(kSticking, 1000);
  const SteppedMotion motion = run_steps<ImplicitStepper>(kSticking, 24);
  for (std::size_t i = exact.y.size() - kEnergyIntegrals; i < exact.y.size(); ++i) {
    EXPECT_NEAR(motion.y[i], exact.y[i], 1e-6 * exact.y.back()) << "of all that was exchanged; integral " << i;
  }
}

TEST(ImplicitStepper, StaysStableWhereExplicitStepsDoNot) {
  const SteppedMotion exact = run_steps<ExplicitStepper>(kSticking, 1000);
  const double expected = find_difference(run_steps<ExplicitStepper>(kSticking, 6).y, exact.y);
  EXPECT_LT(find_difference(run_steps<ImplicitStepper>(kSticking, 6).y, exact.y), 1e-3 * expected);
}

TEST(ImplicitStepper, DenseOutputMeetsTheMotion) {
  const SteppedMotion step = run_steps<ImplicitStepper>(kSticking, 12);
  const SteppedMotion exact = run_steps<ExplicitStepper>(kSticking * 23.0 / 24.0, 1000);
  EXPECT_LT(find_difference(step.middle, exact.y), 1e-5);
}

// In the middle of a step both bends of the quintic count alike; elsewhere each has its own weight.
TEST(ImplicitStepper, DenseOutputOfCoordinatesIsQuinticThroughout) {
  const Study tight = make_tight_study();
  const Mechanism mechanism = oracle::make_point_mass_pendulum();
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  MotionEquations equations(system, {});
  const ErrorTolerance tolerance(tight, 1, 2 * equations.n_free());
  SolverStatistics statistics;
  const State start = make_state(system, assembly);
  std::vector<double> y(equations.size(), 0.0);
  std::ranges::copy(start.q, y.begin());
  std::ranges::copy(start.v, y.begin() + 1);
  std::vector<double> slope(y.size());
  equations.eval(0.0, y.data(), slope.data());
  ImplicitStepper stepper(equations, statistics, tolerance, kFirstStep);
  constexpr double kStep = 0.05;  // [s]
  stepper.begin(0.0, y, slope, false);
  stepper.end_at(kStep);
  for (const double share : {0.2, 0.35, 0.7}) {
    stepper.dense().interpolate(share, y.size(), y.data());
    MotionIntegrator motion(system, tight, 1.0);
    motion.begin(start);
    while (motion.time() < share * kStep) motion.advance(share * kStep);
    // A quintic is off by h⁶ φ⁽⁶⁾/720 · s³ r³ here some 1e-10; one with its bends exchanged by 1e-6.
    EXPECT_NEAR(y[0], motion.y()[0], 2e-9) << share;
  }
}

TEST(ImplicitStepper, EndsWithTheSlopeOfItsEnd) {
  Press press;
  ImplicitStepper stepper(press.equations, press.statistics, press.tolerance, kFirstStep);
  stepper.begin(press.time, press.y, press.slope, false);
  stepper.end_at(5e-6);
  std::vector<double> slope(press.slope.size());
  press.equations.eval(press.time + 5e-6, stepper.end().data(), slope.data());
  for (std::size_t i = 0; i < slope.size(); ++i) EXPECT_EQ(stepper.end_slope()[i], slope[i]) << i;
}

TEST(ImplicitStepper, CountsItsEvaluations) {
  Press press;
  ImplicitStepper stepper(press.equations, press.statistics, press.tolerance, kFirstStep);
  stepper.begin(press.time, press.y, press.slope, false);
  EXPECT_EQ(press.statistics.evaluations, 1) << "for the contacts' answer";
  stepper.end_at(5e-6);
  EXPECT_GE(press.statistics.evaluations, 1 + 6) << "one a stage at least";
  EXPECT_LE(press.statistics.evaluations, 1 + 6 * 6) << "with few corrections";
}

TEST(ImplicitStepper, AStateWithoutASlopeIsRejected) {
  Press press;
  ImplicitStepper stepper(press.equations, press.statistics, press.tolerance, kFirstStep);
  press.y.front() = std::nan("");
  stepper.begin(press.time, press.y, press.slope, false);
  EXPECT_FALSE(stepper.attempt(1e-6, 1.0));
  EXPECT_LT(stepper.next_step(), 1e-6);
}

// Event location looks at the workspace: it must not find there what a stage was before it was given up.
TEST(ImplicitStepper, AStepThatCannotBeSolvedEndsNowhere) {
  Press press;
  ImplicitStepper stepper(press.equations, press.statistics, press.tolerance, kFirstStep);
  stepper.begin(press.time, press.y, press.slope, false);
  stepper.end_at(0.5);  // half a turn of the cranks
  EXPECT_TRUE(std::isnan(stepper.end().front()));
  EXPECT_TRUE(std::isnan(press.equations.workspace.coordinates.angle.front()));
  for (const ContactForces& forces : press.equations.workspace.contact_forces) {
    EXPECT_FALSE(forces.gap.penetration > 0.0);
  }
}

// Of a tolerance next to rounding a stage can be solved no further than rounding lets it.
TEST(ImplicitStepper, SolvesStagesToRoundingWhereToleranceAsksForMore) {
  Press press;
  Study study = press.tight;
  study.relative_tolerance = 1e-14;
  study.absolute_tolerance = 1e-15;
  const ErrorTolerance tolerance{study, static_cast<std::size_t>(press.system.tables.counts.n_free_turns),
                                 2 * press.equations.n_free()};
  ImplicitStepper stepper(press.equations, press.statistics, tolerance, kFirstStep);
  stepper.begin(press.time, press.y, press.slope, false);
  for (const double h : {1e-7, 1e-6}) {
    stepper.end_at(h);
    stepper.accept();
    for (const double value : stepper.end()) ASSERT_TRUE(std::isfinite(value)) << h;
  }
}

}  // namespace
}  // namespace gudgeon
