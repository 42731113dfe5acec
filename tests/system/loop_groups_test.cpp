// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/system/loop_groups.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

// Loops of these kinds over so many unknown turns; numbers of unknowns, not geometry, make groups.
Tables make_loops(int n_unknowns, const std::vector<ClosureKind>& kinds) {
  Tables tables;
  tables.counts.n_free_turns = n_unknowns;
  for (const ClosureKind kind : kinds) {
    tables.closures.emplace_back();
    tables.closures.back().kind = kind;
  }
  return tables;
}

std::vector<std::vector<int>> list_closures(const std::vector<LoopGroup>& groups) {
  std::vector<std::vector<int>> closures;
  for (const LoopGroup& group : groups) closures.push_back(group.closures);
  return closures;
}

using Lists = std::vector<std::vector<int>>;

TEST(LoopGroups, KnownDriversComeBeforeDyadsAndDyadsBeforePairs) {
  // Loops 0 and 1 close together once 3 is known, which the dyad 2 says once the driver 3 has said 4.
  const Tables tables = make_loops(6, {ClosureKind::point, ClosureKind::line, ClosureKind::line, ClosureKind::angle});
  const auto groups = find_loop_groups(tables, {{0, 1, 2, 3}, {1, 2, 0}, {3, 4}, {4, 5}}, {5});
  EXPECT_EQ(list_closures(groups), (Lists{{3}, {2}, {0, 1}}));
  EXPECT_TRUE(groups[1].is_dyad);
  EXPECT_FALSE(groups[0].is_dyad || groups[2].is_dyad);
  EXPECT_EQ(groups[2].unknowns, (std::vector<int>{0, 1, 2})) << "in the order in which the loops have them";
  for (const LoopGroup& group : groups) EXPECT_TRUE(group.is_determined);
}

TEST(LoopGroups, LoopsThatShareNoUnknownAreNoPair) {
  // One loop has a row too many, the other an unknown: together they have as many rows as unknowns, and yet the unknown
  // of the second stays.
  const Tables tables = make_loops(4, {ClosureKind::point, ClosureKind::point, ClosureKind::point});
  const auto groups = find_loop_groups(tables, {{0}, {1, 2, 3}, {1, 2, 3}}, {});
  EXPECT_EQ(list_closures(groups), (Lists{{0, 1, 2}}));
}

TEST(LoopGroups, WhatAPairTellsOpensTheLoopsBesideIt) {
  const Tables tables = make_loops(8, std::vector<ClosureKind>(4, ClosureKind::point));
  const auto groups = find_loop_groups(tables, {{5, 6, 7}, {4, 3, 5, 0}, {0, 1, 2}, {1, 2, 3}}, {});
  EXPECT_EQ(list_closures(groups), (Lists{{2, 3}, {1}, {0}}));
}

TEST(LoopGroups, TheRestIsOneGroup) {
  // A row of four-bars that nothing drives: three unknowns a loop, one of them shared with the next loop.
  constexpr int kLoops = 3000;
  Lists unknowns;
  std::vector<int> all;
  for (int k = 0; k < kLoops; ++k) {
    unknowns.push_back({2 * k, 2 * k + 1, 2 * k + 2});
    all.push_back(k);
  }
  const Tables tables = make_loops(2 * kLoops + 1, std::vector<ClosureKind>(kLoops, ClosureKind::point));
  const auto undriven = find_loop_groups(tables, unknowns, {});
  ASSERT_EQ(list_closures(undriven), Lists{all});
  EXPECT_FALSE(undriven[0].is_determined);
  EXPECT_EQ(undriven[0].unknowns.size(), 2u * kLoops + 1u);
  const auto driven = find_loop_groups(tables, unknowns, {0});
  ASSERT_EQ(driven.size(), static_cast<std::size_t>(kLoops)) << "one known angle makes all of them dyads";
  for (int k = 0; k < kLoops; ++k) EXPECT_EQ(driven[k].unknowns, (std::vector<int>{2 * k + 1, 2 * k + 2}));
}

}  // namespace
}  // namespace gudgeon
