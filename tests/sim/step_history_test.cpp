// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Polynomials through the ends of steps.
#include "gudgeon/sim/step_history.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/system/assembly.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

// A motion of degree 5 in all three coordinates, and its derivatives.
double eval_quintic(double t, int derivative) {
  constexpr double kCoefficients[] = {0.3, -1.2, 0.7, 2.1, -1.4, 0.5};
  double sum = 0.0;
  for (int p = derivative; p < 6; ++p) {
    double factor = kCoefficients[p];
    for (int d = 0; d < derivative; ++d) factor *= p - d;
    sum += factor * std::pow(t, p - derivative);
  }
  return sum;
}

struct Motion {
  Motion()
      : assembly(assemble(mechanism)), system(compile(mechanism, assembly)), equations(system, {}), steps(equations) {}

  void note(double time) {
    const std::size_t n = equations.n_free();
    std::vector<double> y(equations.size(), 0.0);
    std::vector<double> slope(equations.size(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      y[i] = eval_quintic(time, 0);
      slope[i] = y[n + i] = eval_quintic(time, 1);
      slope[n + i] = eval_quintic(time, 2);
    }
    steps.note(time, y, slope, equations.contact_modes);
  }

  Mechanism mechanism = make_balls({{{}, {}}}, {}, 1e6);
  Assembly assembly;
  System system;
  MotionEquations equations;
  StepHistory steps;
};

TEST(StepHistory, GivesCoordinatesOfDegreeFiveInBothSteps) {
  Motion motion;
  for (const double time : {0.1, 0.4, 0.9}) motion.note(time);
  std::vector<double> y(motion.equations.n_states());
  for (const double time : {0.1, 0.15, 0.3, 0.4, 0.55, 0.8, 0.9}) {
    motion.steps.interpolate(time, y.data());
    EXPECT_NEAR(y[0], eval_quintic(time, 0), 1e-14) << time;
  }
}

// Rates are cubics through values and slopes: off by h⁴/384 times the fourth derivative, at most.
TEST(StepHistory, GivesRatesOfFourthOrder) {
  Motion motion;
  for (const double time : {0.1, 0.2, 0.3}) motion.note(time);
  std::vector<double> y(motion.equations.n_states());
  const std::size_t n = motion.equations.n_free();
  for (const double time : {0.1, 0.2, 0.3}) {
    motion.steps.interpolate(time, y.data());
    EXPECT_NEAR(y[n], eval_quintic(time, 1), 1e-14) << time;
  }
  for (const double time : {0.15, 0.25}) {
    motion.steps.interpolate(time, y.data());
    EXPECT_NEAR(y[n], eval_quintic(time, 1), 1.0001e-4 / 384.0 * std::abs(eval_quintic(0.2, 5))) << time;
    EXPECT_GT(std::abs(y[n] - eval_quintic(time, 1)), 1e-8);
  }
}

TEST(StepHistory, KnowsTheContactModesOfEachStep) {
  Motion motion;
  motion.note(0.1);
  motion.equations.contact_modes[0] = {true, 0.3};
  motion.note(0.2);
  motion.equations.contact_modes[0] = {};
  motion.note(0.3);
  EXPECT_TRUE(motion.steps.find_contact_modes(0.15)[0].in_contact);
  EXPECT_FALSE(motion.steps.find_contact_modes(0.25)[0].in_contact);
  EXPECT_EQ(motion.steps.time(0), 0.3);
  EXPECT_EQ(motion.steps.time(2), 0.1);
  motion.steps.clear();
  EXPECT_EQ(motion.steps.n_states(), 0);
}

}  // namespace
}  // namespace gudgeon
