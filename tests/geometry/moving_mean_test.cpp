// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/geometry/moving_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace gudgeon {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// Three boxes of width w have the variance 3 w²/12 of a sum of three uniform variables, but for what a box over whole
// cells has more: m whole ones and a rest r at both ends, 2 (Σ k² + r (m + 1)²)/w instead of w²/12.
double find_variance(double width) {
  const double half = std::floor(0.5 * (width - 1.0));
  const double rest = 0.5 * (width - 1.0) - half;
  double squares = rest * (half + 1.0) * (half + 1.0);
  for (double k = 1.0; k <= half; ++k) squares += k * k;
  return 3.0 * 2.0 * squares / width;
}

TEST(MovingMean, SpreadsOneCellByThreeBoxes) {
  for (const double width : {1.5, 3.0, 4.25, 20.0, 33.0}) {
    std::vector<double> values(101, 0.0);
    values[50] = 2.0;
    smooth_by_moving_means(values, width, true);
    EXPECT_NEAR(sum(values), 2.0, 1e-14);
    double variance = 0.0;
    for (int k = 0; k < 101; ++k) {
      variance += 0.5 * values[k] * (k - 50) * (k - 50);
      EXPECT_GE(values[k], 0.0);
      EXPECT_NEAR(values[k], values[100 - k], 1e-15);
      if (std::abs(k - 50) > 1.5 * width + 1.5) {
        EXPECT_EQ(values[k], 0.0) << k << " of width " << width;
      }
    }
    EXPECT_NEAR(variance, find_variance(width), 1e-12) << width;
    EXPECT_NEAR(variance, 0.25 * width * width, 0.8);
  }
}

TEST(MovingMean, KeepsLinesAndSumsAlongALine) {
  std::vector<double> values(60);
  for (int k = 0; k < 60; ++k) values[k] = 3.0 + 0.25 * k;
  const double before = sum(values);
  smooth_by_moving_means(values, 4.5, false);
  EXPECT_NEAR(sum(values), before, 1e-12);
  for (int k = 8; k < 52; ++k) EXPECT_NEAR(values[k], 3.0 + 0.25 * k, 1e-13);
  EXPECT_GT(values.front(), 3.0);  // what would lie beyond the end comes back
  EXPECT_LT(values.back(), 3.0 + 14.75);
}

TEST(MovingMean, GoesOnAcrossTheSeamOfACircleOnly) {
  for (const bool is_round : {true, false}) {
    std::vector<double> values(40, 0.0);
    values[1] = 1.0;
    smooth_by_moving_means(values, 5.0, is_round);
    EXPECT_NEAR(sum(values), 1.0, 1e-15);
    EXPECT_EQ(values[39] > 0.0, is_round);
  }
}

TEST(MovingMean, NoWiderThanACellChangesNothing) {
  const std::vector<double> before{1.0, 0.0, 7.0, 2.0};
  for (const double width : {0.0, 0.5, 1.0, std::nan("")}) {
    std::vector<double> values = before;
    smooth_by_moving_means(values, width, true);
    EXPECT_EQ(values, before);
  }
  std::vector<double> values = before;
  smooth_by_moving_means(values, 1e9, true);  // a third of all
  EXPECT_NEAR(sum(values), 10.0, 1e-14);
}

}  // namespace
}  // namespace gudgeon
