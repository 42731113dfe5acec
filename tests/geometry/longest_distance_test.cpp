// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/geometry/longest_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace gudgeon {
namespace {

double find_longest_of_all_pairs(const std::vector<Vec2>& points) {
  double longest = 0.0;
  for (const Vec2 a : points) {
    for (const Vec2 b : points) longest = std::max(longest, norm(a - b));
  }
  return longest;
}

TEST(LongestDistance, FewerThanTwoPointsAreNotApart) {
  EXPECT_EQ(find_longest_distance({}), 0.0);
  EXPECT_EQ(find_longest_distance(std::vector<Vec2>{{3.0, 4.0}}), 0.0);
}

TEST(LongestDistance, ScatteredPointsAreTheFarthestPair) {
  std::mt19937 random(7);
  std::normal_distribution<double> place(0.0, 1.0);
  for (const int n : {2, 5, 32, 33, 100, 2000}) {
    std::vector<Vec2> points;
    for (int k = 0; k < n; ++k) points.push_back({place(random), 0.1 * place(random)});
    EXPECT_DOUBLE_EQ(find_longest_distance(points), find_longest_of_all_pairs(points)) << n << " points";
  }
}

TEST(LongestDistance, PointsInARowOnACircleAndAtOnePlace) {
  std::vector<Vec2> row;
  std::vector<Vec2> circle;
  for (int k = 0; k <= 6000; ++k) {
    row.push_back({0.1 * k, -0.3 * k});
    const double angle = 2.0 * std::numbers::pi * k / 6000.0;
    if (k % 10 == 0) circle.push_back({2.0 * std::cos(angle), 2.0 * std::sin(angle)});
  }
  EXPECT_NEAR(find_longest_distance(row), std::hypot(600.0, 1800.0), 1e-9);
  EXPECT_NEAR(find_longest_distance(circle), 4.0, 1e-12);
  EXPECT_EQ(find_longest_distance(std::vector<Vec2>(100, {1.0, 2.0})), 0.0);
}

TEST(LongestDistance, WhatIsNotFiniteIsPassedOver) {
  std::vector<Vec2> points(40, {1.0, 1.0});
  points[3].x = std::numeric_limits<double>::quiet_NaN();
  points[4].y = std::numeric_limits<double>::infinity();
  points[5] = {4.0, 5.0};
  EXPECT_DOUBLE_EQ(find_longest_distance(points), 5.0);
}

}  // namespace
}  // namespace gudgeon
