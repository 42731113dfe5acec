// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The coefficients against all order conditions, and the damping of infinitely fast decays.
#include "gudgeon/sim/esdirk.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gudgeon {
namespace {

constexpr int kStages = Esdirk::kStages;
using Vector = Eigen::Matrix<double, kStages, 1>;
using Matrix = Eigen::Matrix<double, kStages, kStages>;

template <class Row>
Vector make_vector(const Row& row) {
  Vector vector;
  for (int i = 0; i < kStages; ++i) vector[i] = row[i];
  return vector;
}

Matrix make_matrix() {
  Matrix a = Matrix::Zero();
  for (int i = 1; i < kStages; ++i) {
    for (int j = 0; j < i; ++j) a(i, j) = Esdirk::kCoefficients[i][j];
    a(i, i) = Esdirk::kDiagonal;
  }
  return a;
}

Vector power(const Vector& v, int exponent) { return v.array().pow(exponent); }
Vector times(const Vector& a, const Vector& b) { return a.cwiseProduct(b); }

// Σ weight · what each rooted tree of that order asks for, less what it should be (Hairer, Nørsett & Wanner 1993,
// II.2).
struct Condition {
  int order;
  Vector tree;
  double value;
};

std::vector<Condition> list_conditions() {
  const Matrix a = make_matrix();
  const Vector c = make_vector(Esdirk::kNodes);
  const Vector one = Vector::Ones();
  const Vector ac = a * c;
  return {
      {1, one, 1.0},
      {2, c, 1.0 / 2},
      {3, power(c, 2), 1.0 / 3},
      {3, ac, 1.0 / 6},
      {4, power(c, 3), 1.0 / 4},
      {4, times(c, ac), 1.0 / 8},
      {4, a * power(c, 2), 1.0 / 12},
      {4, a * ac, 1.0 / 24},
      {5, power(c, 4), 1.0 / 5},
      {5, times(power(c, 2), ac), 1.0 / 10},
      {5, times(ac, ac), 1.0 / 20},
      {5, times(c, a * power(c, 2)), 1.0 / 15},
      {5, times(c, a * ac), 1.0 / 30},
      {5, a * power(c, 3), 1.0 / 20},
      {5, a * times(c, ac), 1.0 / 40},
      {5, a * (a * power(c, 2)), 1.0 / 60},
      {5, a * (a * ac), 1.0 / 120},
  };
}

TEST(Esdirk, NodesAreTheRowsSums) {
  const Vector sums = make_matrix().rowwise().sum();
  for (int i = 0; i < kStages; ++i) EXPECT_NEAR(sums[i], Esdirk::kNodes[i], 1e-14) << i;
}

TEST(Esdirk, TheLastStageIsTheEnd) {
  const Matrix a = make_matrix();
  for (int j = 0; j < kStages; ++j) EXPECT_EQ(a(kStages - 1, j), Esdirk::kWeights[j]) << j;
}

TEST(Esdirk, HasOrderFive) {
  const Vector b = make_vector(Esdirk::kWeights);
  for (const Condition& condition : list_conditions()) EXPECT_NEAR(b.dot(condition.tree), condition.value, 1e-14);
}

TEST(Esdirk, EstimatesWithOrderFour) {
  const Vector d = make_vector(Esdirk::kErrorWeights);
  double largest = 0.0;
  for (const Condition& condition : list_conditions()) {
    const double sum = d.dot(condition.tree);
    largest = std::max(largest, std::abs(sum));
    if (condition.order == 5) continue;
    EXPECT_NEAR(sum, 0.0, 1e-14);
  }
  EXPECT_GT(largest, 1e-4) << "an estimate of the fifth order estimates nothing";
}

// ẏ = λ y with λ h to −∞: every stage that is solved for, so also the end, goes to zero.
TEST(Esdirk, ForgetsWhatDecaysInfinitelyFast) {
  const Matrix a = make_matrix();
  for (const double decay : {1e3, 1e6}) {
    const Matrix system = Matrix::Identity() + decay * a;
    const Vector stages = system.partialPivLu().solve(Vector::Ones());
    EXPECT_LT(std::abs(stages[kStages - 1]), 20.0 / decay) << decay;
  }
}

TEST(Esdirk, SharesAreARuleOfSecondOrderWithoutNegativeWeights) {
  const Vector shares = make_vector(Esdirk::kShares);
  EXPECT_GE(shares.minCoeff(), 0.0);
  EXPECT_NEAR(shares.sum(), 1.0, 1e-15);
  EXPECT_NEAR(shares.dot(make_vector(Esdirk::kNodes)), 0.5, 1e-15);
}

}  // namespace
}  // namespace gudgeon
