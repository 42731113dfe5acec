// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The sparse factorisation against a dense one, the signs of its pivots, and how much fill it makes.
#include "gudgeon/system/elimination.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "gudgeon/system/tables.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct SaddlePoint {
  int n_constraints = 0;
  std::vector<std::pair<int, int>> pattern;
  MatrixXd matrix;
};

// [H Jᵀ; J 0] with H diagonally dominant, and a coordinate in every row that outweighs the others.
SaddlePoint make_random_matrix(int n_coordinates, int n_constraints, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  SaddlePoint result{n_constraints, {}, MatrixXd::Zero(n_coordinates + n_constraints, n_coordinates + n_constraints)};
  const auto set = [&](int row, int column, double value) {
    result.matrix(row, column) = result.matrix(column, row) = value;
    result.pattern.emplace_back(uniform(random) > 0.0 ? std::pair{row, column} : std::pair{column, row});
  };
  for (int i = 0; i < n_coordinates; ++i) {
    for (int j = 0; j < i; ++j) {
      if (uniform(random) > 0.6) set(i, j, uniform(random));
    }
  }
  for (int i = 0; i < n_coordinates; ++i) result.matrix(i, i) = 1.0 + result.matrix.row(i).cwiseAbs().sum();
  for (int r = 0; r < n_constraints; ++r) {
    for (int j = 0; j < n_coordinates; ++j) {
      if (j == 2 * r) {
        set(n_coordinates + r, j, 5.0 + uniform(random));
      } else if (uniform(random) > 0.6) {
        set(n_coordinates + r, j, uniform(random));
      }
    }
  }
  return result;
}

std::vector<double> fill_values(const Elimination& elimination, const SaddlePoint& problem) {
  std::vector<double> values(elimination.n_values(), 0.0);
  for (int i = 0; i < elimination.size(); ++i) values[elimination.find_slot(i, i)] = problem.matrix(i, i);
  for (const auto& [row, column] : problem.pattern) {
    values[elimination.find_slot(row, column)] = problem.matrix(row, column);
  }
  return values;
}

class RandomSaddlePoint : public testing::TestWithParam<unsigned> {
 protected:
  int n_coordinates = 3 + static_cast<int>(GetParam()) * 2;
  int n_constraints = static_cast<int>(GetParam()) % 5;
  SaddlePoint problem = make_random_matrix(n_coordinates, n_constraints, GetParam());
  Elimination elimination{n_coordinates + n_constraints, n_constraints, problem.pattern};
  std::vector<double> values = fill_values(elimination, problem);
  std::vector<double> inverse_pivots = std::vector<double>(elimination.size());
};

TEST_P(RandomSaddlePoint, SolvesAsDenseDoes) {
  VectorXd right = VectorXd::Random(elimination.size());
  const VectorXd expected = problem.matrix.fullPivLu().solve(right);
  for (const bool again : {false, true, true}) {  // factors serve any number of right-hand sides
    VectorXd x = right;
    if (again) {
      elimination.solve(values.data(), inverse_pivots.data(), x.data());
    } else {
      elimination.factor_and_solve(values.data(), inverse_pivots.data(), x.data());
    }
    // Condition numbers here are below 1e3.
    EXPECT_LT((x - expected).lpNorm<Eigen::Infinity>(), 1e-12 * (1.0 + expected.lpNorm<Eigen::Infinity>()));
  }
}

TEST_P(RandomSaddlePoint, PivotsOfRowsAreNegative) {
  std::vector<double> x(inverse_pivots.size());
  elimination.factor_and_solve(values.data(), inverse_pivots.data(), x.data());
  EXPECT_EQ(std::ranges::count_if(inverse_pivots, [](double p) { return p < 0.0; }), n_constraints);
  EXPECT_EQ(std::ranges::count_if(inverse_pivots, [](double p) { return p > 0.0; }), n_coordinates);
}

TEST_P(RandomSaddlePoint, MultipliesAsDenseDoes) {
  const VectorXd x = VectorXd::Random(elimination.size());
  VectorXd y = VectorXd::Random(elimination.size());
  const VectorXd expected = y - problem.matrix * x;
  elimination.subtract_product(values.data(), x.data(), y.data());
  EXPECT_LT((y - expected).lpNorm<Eigen::Infinity>(), 1e-13 * static_cast<double>(elimination.size()));  // rounding
}

TEST_P(RandomSaddlePoint, EverySlotIsItsOwn) {
  std::vector<bool> taken(elimination.n_values(), false);
  const auto take = [&](int row, int column) {
    const int slot = elimination.find_slot(row, column);
    ASSERT_GE(slot, 0);
    ASSERT_LT(slot, elimination.n_values());
    EXPECT_EQ(elimination.find_slot(column, row), slot);
    EXPECT_FALSE(taken[slot]);
    taken[slot] = true;
  };
  for (int i = 0; i < elimination.size(); ++i) take(i, i);
  for (const auto& [row, column] : problem.pattern) take(row, column);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSaddlePoint, testing::Range(1u, 16u));

Tables compile_all_rows(const Mechanism& mechanism) { return compile_tables(mechanism, find_topology(mechanism)); }

TEST(Elimination, MakesNoFillInATree) {
  // Pairs of a branching tree that are each other's ancestors: 0 carries 1 and 2, 1 carries 3 and 4, 2 carries 5.
  const std::vector<std::pair<int, int>> pattern{{1, 0}, {2, 0}, {3, 1}, {3, 0}, {4, 1}, {0, 4}, {5, 2}, {5, 0}};
  const Elimination elimination(6, 0, pattern);
  EXPECT_EQ(elimination.n_values(), 6 + static_cast<int>(pattern.size()));
  EXPECT_EQ(elimination.find_slot(1, 2), -1);
  EXPECT_EQ(elimination.find_slot(3, 4), -1);
  // A chain couples every bar with every other.
  EXPECT_EQ(compile_all_rows(oracle::make_pendulum_chain(6)).elimination.n_values(), 6 * 7 / 2);
}

TEST(Elimination, FillGrowsLinearlyWithTheNumberOfLoops) {
  const auto count = [](int n) { return compile_all_rows(oracle::make_n_four_bar(n)).elimination.n_values(); };
  const int growth = count(20) - count(10);
  EXPECT_EQ(count(30) - count(20), growth);
  EXPECT_EQ(count(60) - count(40), 2 * growth);
  // A loop adds four equations, each of which meets a handful of others.
  EXPECT_LE(growth, 10 * 4 * 6);
}

TEST(Elimination, TellsASingularMatrix) {
  // Two equal constraint rows on one coordinate.
  const Elimination elimination(3, 2, {{1, 0}, {2, 0}});
  std::vector<double> values(elimination.n_values(), 0.0);
  values[elimination.find_slot(0, 0)] = 2.0;
  values[elimination.find_slot(1, 0)] = values[elimination.find_slot(2, 0)] = 1.0;
  std::vector<double> inverse_pivots(3);
  std::vector<double> x(inverse_pivots.size());
  elimination.factor_and_solve(values.data(), inverse_pivots.data(), x.data());
  EXPECT_TRUE(std::ranges::any_of(inverse_pivots, [](double p) { return !std::isfinite(p); }));
}

}  // namespace
}  // namespace gudgeon
