// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Orders, weights and stages of the Runge-Kutta pair, on problems with closed forms.
#include "gudgeon/sim/tsitouras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gudgeon {
namespace {

// ẏ = −2 t y², y = 1/(1 + t²): not linear, not autonomous; beside it ż = y cos t − z y, for coupling.
void eval_problem(double t, const double* y, double* slope) {
  slope[0] = -2.0 * t * y[0] * y[0];
  slope[1] = y[0] * std::cos(t) - y[1] * y[0];
}

constexpr double kStartTime = 0.5;
std::vector<double> make_start() { return {1.0 / (1.0 + kStartTime * kStartTime), 0.3}; }

const auto kRhs = [](int, double t, const double* y, double* slope) { eval_problem(t, y, slope); };

// Goes on for `duration` in n steps and stays in the last one.
Tsitouras run_steps(double duration, int n) {
  Tsitouras stepper(2, 0);
  std::vector<double> y = make_start();
  std::vector<double> slope(2);
  eval_problem(kStartTime, y.data(), slope.data());
  for (int k = 0; k < n; ++k) {
    stepper.begin(kStartTime + duration * k / n, y, slope);
    stepper.attempt(duration / n, kRhs);
    y = stepper.end();
    slope.assign(stepper.end_slope().begin(), stepper.end_slope().end());
  }
  return stepper;
}

// Largest error of the dense output of a first step of length h.
double find_dense_error(double h) {
  const Tsitouras coarse = run_steps(h, 1);
  double error = 0.0;
  for (const double share : {0.17, 0.4, 0.63, 0.88}) {
    std::vector<double> y(2);
    coarse.interpolate(share, 2, y.data());
    const Tsitouras fine = run_steps(share * h, 64);
    for (int i = 0; i < 2; ++i) error = std::max(error, std::abs(y[i] - fine.end()[i]));
  }
  return error;
}

double find_order(double coarse_error, double fine_error) { return std::log2(coarse_error / fine_error); }

TEST(Tsitouras, ConvergesWithOrderFive) {
  const auto error = [](int n) { return std::abs(run_steps(1.5, n).end()[0] - 1.0 / (1.0 + 2.0 * 2.0)); };
  // The next term of the error shows: at these lengths it moves the order by a third at most, a wrong one by a whole.
  EXPECT_NEAR(find_order(error(32), error(64)), 5.0, 0.35);
  EXPECT_NEAR(find_order(error(64), error(128)), 5.0, 0.35);
  EXPECT_LT(error(64), 1e-9);
}

TEST(Tsitouras, DenseOutputHasOrderFour) {
  // One step's local error goes with the order plus one.
  EXPECT_NEAR(find_order(find_dense_error(0.05), find_dense_error(0.025)), 5.0, 0.35);
  EXPECT_NEAR(find_order(find_dense_error(0.025), find_dense_error(0.0125)), 5.0, 0.35);
}

TEST(Tsitouras, ErrorEstimateIsThatOfTheFourthOrder) {
  const auto estimate = [](double h) { return std::abs(run_steps(h, 1).error()[1]); };
  // Its series converges slowly: at 0.1 the next term still takes half an order.
  EXPECT_NEAR(find_order(estimate(0.025), estimate(0.0125)), 5.0, 0.3);
  const double true_error = std::abs(run_steps(0.1, 1).end()[0] - 1.0 / 1.36);
  EXPECT_LT(true_error, std::abs(run_steps(0.1, 1).error()[0])) << "the estimate is on the safe side";
}

TEST(Tsitouras, DenseOutputIsExactForQuarticsAndMeetsBothEnds) {
  // ẏ = 4 t³ − 6 t: exact for polynomials up to the order; 1e-14 is a few roundings of numbers near 1.
  Tsitouras stepper(1, 0);
  stepper.begin(0.5, {0.0}, {4.0 * 0.125 - 3.0});
  stepper.attempt(0.8, [](int, double t, const double*, double* slope) { slope[0] = 4.0 * t * t * t - 6.0 * t; });
  const auto exact = [](double t) { return t * t * t * t - 3.0 * t * t - (0.0625 - 0.75); };
  double y = 0.0;
  for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    stepper.interpolate(share, 1, &y);
    EXPECT_NEAR(y, exact(0.5 + 0.8 * share), 1e-14) << share;
  }
  EXPECT_EQ(y, stepper.end()[0]) << "the end exactly, not to rounding";
}

TEST(Tsitouras, WeightsSumToOneAndIntegrateAlong) {
  const auto& weights = Tsitouras::kWeights;
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-15);
  // A quadrature of order five: ∫ tᵏ dt = 1/(k + 1) up to k = 4, and not beyond.
  for (int power = 1; power <= 5; ++power) {
    double sum = 0.0;
    for (int s = 0; s < Tsitouras::kStages; ++s) sum += weights[s] * std::pow(Tsitouras::kNodes[s], power);
    if (power <= 4) {
      EXPECT_NEAR(sum, 1.0 / (power + 1), 1e-15) << power;
    } else {
      EXPECT_GT(std::abs(sum - 1.0 / 6.0), 1e-4);
    }
  }
}

TEST(Tsitouras, StagesAreCalledInOrderAtTheirNodesAndTheLastIsTheEnd) {
  Tsitouras stepper(2, 0);
  std::vector<double> slope(2);
  const std::vector<double> start = make_start();
  eval_problem(0.4, start.data(), slope.data());
  stepper.begin(0.4, start, slope);
  std::vector<int> stages;
  stepper.attempt(0.2, [&](int stage, double t, const double* y, double* dydt) {
    EXPECT_DOUBLE_EQ(t, 0.4 + 0.2 * Tsitouras::kNodes[stage]);
    stages.push_back(stage);
    EXPECT_EQ(y == stepper.end().data(), stage == 6);
    eval_problem(t, y, dydt);
  });
  EXPECT_EQ(stages, (std::vector<int>{1, 2, 3, 4, 5, 6}));
  eval_problem(0.4 + 0.2, stepper.end().data(), slope.data());
  EXPECT_THAT(stepper.end_slope(), testing::ElementsAreArray(slope)) << "first stage of the next step";
  // Another attempt begins at the same start, whatever the one before did.
  const std::vector<double> first = stepper.end();
  stepper.attempt(0.7, kRhs);
  stepper.attempt(0.2, kRhs);
  EXPECT_EQ(stepper.end(), first);
  EXPECT_EQ(stepper.start(), start);
}

// ∫ 5 t⁴ dt beside a state: a rule of order five is exact for it, and no stage sees it.
TEST(Tsitouras, SumsIntegralsWithTheWeights) {
  Tsitouras stepper(1, 1);
  const double start = std::pow(0.3, 4);
  stepper.begin(0.3, {1.0, 2.0}, {-1.0, 5.0 * start});
  stepper.attempt(0.5, [](int, double t, const double* y, double* slope) {
    slope[0] = -y[0];
    slope[1] = 5.0 * std::pow(t, 4);
  });
  EXPECT_NEAR(stepper.end()[1], 2.0 + std::pow(0.8, 5) - std::pow(0.3, 5), 1e-15);
  EXPECT_EQ(stepper.error().size(), 1u) << "an integral has no tolerance";
}

// ẏ = −40 y beside a slow component that counts for nothing.
TEST(Tsitouras, FeelsTheFastestRate) {
  constexpr double kRate = 40.0;
  Tsitouras stepper(2, 0);
  for (const double h : {1e-3, 0.05, 0.1}) {
    stepper.begin(0.0, {2.0, 1.0}, {-2.0 * kRate, 1.0});
    stepper.attempt(h, [](int, double t, const double* y, double* slope) {
      slope[0] = -kRate * y[0];
      slope[1] = std::cos(t);
    });
    const auto weigh = [](std::size_t i, double) { return i == 0 ? 1.0 : 0.0; };
    EXPECT_NEAR(stepper.find_stiffness(2, weigh), kRate * h, 1e-9 * kRate * h);
    EXPECT_NEAR(stepper.find_stiffness(1, [](std::size_t, double) { return 1e6; }), kRate * h, 1e-9 * kRate * h);
  }
}

TEST(Tsitouras, FeelsNothingWhereNothingMoves) {
  Tsitouras stepper(1, 0);
  stepper.begin(0.0, {1.0}, {0.0});
  stepper.attempt(0.1, [](int, double, const double*, double* slope) { slope[0] = 0.0; });
  EXPECT_EQ(stepper.find_stiffness(1, [](std::size_t, double) { return 1.0; }), 0.0);
}

}  // namespace
}  // namespace gudgeon
