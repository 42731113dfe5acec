// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/system/free_gradients.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

// Two rows a closure, as in the closure Jacobian.
SparseMatrix make_rows(int n_rows, int n_columns, const std::vector<Eigen::Triplet<double>>& entries) {
  SparseMatrix rows(n_rows, n_columns);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

TEST(FreeGradients, WithoutClosuresEachIsFreeOnce) {
  const FreeGradients found =
      find_free_gradients(SparseMatrix(0, 4), {{{2, 1.0}}, {{0, 1.0}}, {{2, -3.0}}, {}, {{0, 1.0}, {1, 1.0}}});
  EXPECT_EQ(found.free, (std::vector<int>{0, 1, 4})) << "the third is the first again, the fourth never moves";
  EXPECT_EQ(found.n_free, 4);
}

TEST(FreeGradients, AClosureLeavesOnlySomeOfThem) {
  // x0 + x1 + x2 = 0 and x1 = 2 x2: one direction is left of these three, and x3 is free.
  const SparseMatrix closures = make_rows(2, 4, {{0, 0, 1.0}, {0, 1, 1.0}, {0, 2, 1.0}, {1, 1, 1.0}, {1, 2, -2.0}});
  const std::vector<Gradient> gradients{{{1, 1.0}, {2, -2.0}}, {{2, 1.0}}, {{3, 1.0}}, {{0, 1.0}}};
  const FreeGradients found = find_free_gradients(closures, gradients);
  EXPECT_EQ(found.free, (std::vector<int>{1, 2}));
  EXPECT_EQ(found.n_free, 2);
}

TEST(FreeGradients, GradientsConnectPartsThatClosuresDoNot) {
  const SparseMatrix closures = make_rows(4, 4, {{0, 0, 1.0}, {0, 1, -1.0}, {2, 2, 1.0}, {2, 3, -1.0}});
  const std::vector<Gradient> gradients{{{0, 1.0}, {2, 1.0}}, {{1, 1.0}}, {{3, 1.0}}};
  const FreeGradients found = find_free_gradients(closures, gradients);
  EXPECT_EQ(found.free, (std::vector<int>{0, 1})) << "the third follows from the two before it";
  EXPECT_EQ(found.n_free, 2);
}

TEST(FreeGradients, ManyPartsTakeNoLongerThanTheirNumber) {
  // As one matrix of free directions, 10 000 by 10 000 numbers.
  constexpr int kParts = 10000;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Gradient> gradients;
  for (int k = 0; k < kParts; ++k) {
    entries.emplace_back(2 * k, 2 * k, 1.0);
    entries.emplace_back(2 * k, 2 * k + 1, -1.0);
    gradients.push_back({{2 * k + 1, 1.0}});
    gradients.push_back({{2 * k, 1.0}});
  }
  const FreeGradients found = find_free_gradients(make_rows(2 * kParts, 2 * kParts, entries), gradients);
  ASSERT_EQ(found.free.size(), static_cast<std::size_t>(kParts));
  for (int k = 0; k < kParts; ++k) ASSERT_EQ(found.free[k], 2 * k);
  EXPECT_EQ(found.n_free, kParts);
}

}  // namespace
}  // namespace gudgeon
