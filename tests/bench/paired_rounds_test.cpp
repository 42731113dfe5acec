// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Spreads of known values, and ratios taken round by round.
#include "bench/paired_rounds.h"

#include <gtest/gtest.h>

namespace gudgeon::bench {
namespace {

TEST(PairedRounds, SpreadIsMedianAndQuartiles) {
  const Spread spread = find_spread({5.0, 1.0, 4.0, 2.0, 3.0});
  EXPECT_DOUBLE_EQ(spread.median, 3.0);
  EXPECT_DOUBLE_EQ(spread.lower, 2.0);
  EXPECT_DOUBLE_EQ(spread.upper, 4.0);
  EXPECT_DOUBLE_EQ(find_spread({1.0, 2.0}).median, 1.5);
}

TEST(PairedRounds, RatiosDoNotSeeWhatDisturbsWholeRounds) {
  double noise = 1.0;
  // Costs of 3 and 2 a piece, the whole round slowed by what it likes.
  PairedRounds rounds(
      {{"three", [&](int n) { return 3.0 * noise * n; }}, {"two", [&](int n) { return 2.0 * noise * n; }}}, 1.0);
  for (int k = 0; k < 5; ++k) {
    noise = 1.0 + 10.0 * k;
    EXPECT_DOUBLE_EQ(rounds.run(), 5.0 * noise);
  }
  EXPECT_DOUBLE_EQ(rounds.find_ratio(1, 0).median, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(rounds.find_ratio(1, 0).upper, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(rounds.find_time(1).median, 2.0 * 21.0);
  EXPECT_EQ(rounds.find("two"), std::optional<std::size_t>(1));
  EXPECT_FALSE(rounds.find("one"));
}

TEST(PairedRounds, TurnsOfSmallWorkAreManyPieces) {
  int most = 0;
  PairedRounds rounds({{"small",
                        [&](int n) {
                          most = std::max(most, n);
                          return 1e-6 * n;
                        }}},
                      1e-4);
  rounds.run();
  EXPECT_GE(most, 50);
  EXPECT_LE(most, 200);
  EXPECT_NEAR(rounds.find_time(0).median, 1e-6, 1e-12);
}

}  // namespace
}  // namespace gudgeon::bench
