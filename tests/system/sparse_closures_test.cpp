// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/system/sparse_closures.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

namespace gudgeon {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Sparse rows; every third one is a sum of two before it, and some are zero.
MatrixXd make_rows(Index n_rows, Index n_columns, std::mt19937& random) {
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  MatrixXd rows = MatrixXd::Zero(n_rows, n_columns);
  for (Index row = 0; row < n_rows; ++row) {
    if (row % 5 == 4) continue;
    if (row % 3 == 2) {
      rows.row(row) = rows.row(row - 1) - 2.0 * rows.row(row - 2);
      continue;
    }
    for (int k = 0; k < 4; ++k) rows(row, static_cast<Index>(random()) % n_columns) = value(random);
  }
  return rows;
}

TEST(RowSpace, IsThatOfTheFullMatrix) {
  std::mt19937 random(23);
  for (const auto& [n_rows, n_columns] : std::vector<std::pair<Index, Index>>{{6, 9}, {30, 40}, {40, 17}, {80, 81}}) {
    const MatrixXd rows = make_rows(n_rows, n_columns, random);
    const RowSpace space(rows.sparseView());
    int rank = 0;
    for (Index row = 0; row < n_rows; ++row) {
      const auto rank_with = static_cast<int>(Eigen::FullPivHouseholderQR<MatrixXd>(rows.topRows(row + 1)).rank());
      EXPECT_EQ(space.is_independent(row), rank_with > rank) << "row " << row << " of " << n_rows;
      rank = rank_with;
    }
    EXPECT_EQ(space.rank(), rank);
    const MatrixXd basis = space.find_free_basis();
    ASSERT_EQ(basis.cols(), n_columns - rank);
    EXPECT_LT((rows * basis).norm(), 1e-12);
    EXPECT_LT((basis.transpose() * basis - MatrixXd::Identity(basis.cols(), basis.cols())).norm(), 1e-12);
    const VectorXd any = VectorXd::Random(n_columns);
    EXPECT_LT((space.find_free_part(any) - basis * (basis.transpose() * any)).norm(), 1e-12);
  }
}

TEST(RowSpace, SeparateLoopsDoNotMeet) {
  // Two rows and three unknowns each: in any order that mixes them, reflections would fill the matrix.
  constexpr int kLoops = 5000;
  std::vector<Eigen::Triplet<double>> entries;
  for (int loop = 0; loop < kLoops; ++loop) {
    for (int k = 0; k < 3; ++k) {
      entries.emplace_back(2 * loop, 3 * loop + k, 1.0 + k);
      entries.emplace_back(2 * loop + 1, 3 * loop + k, 3.0 - 2.0 * k * k);
    }
  }
  SparseMatrix rows(2 * kLoops, 3 * kLoops);
  rows.setFromTriplets(entries.begin(), entries.end());
  const RowSpace space(rows);
  EXPECT_EQ(space.rank(), 2 * kLoops);
  const VectorXd free = space.find_free_part(VectorXd::LinSpaced(3 * kLoops, 1.0, 2.0));
  EXPECT_LT((rows * free).norm(), 1e-10);
  EXPECT_GT(free.norm(), 1.0);
}

}  // namespace
}  // namespace gudgeon
