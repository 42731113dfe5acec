// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The mirrored B-spline of wear depths along a side: where depth goes, what it conserves, and its ends.
#include "gudgeon/geometry/line_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/geometry/guide_motion.h"

namespace gudgeon {
namespace {

constexpr double kLength = 0.6;

TEST(LineProfile, UnwornIsZeroEverywhere) {
  for (const LineProfile& profile : {LineProfile(), LineProfile(std::vector<double>(8, 0.0), kLength)}) {
    EXPECT_FALSE(profile.is_worn());
    EXPECT_EQ(profile.least_depth(), 0.0);
    for (const double position : {0.0, -0.3, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
      EXPECT_EQ(profile.eval(position).depth, 0.0);
      EXPECT_EQ(profile.eval(position).slope, 0.0);
    }
  }
}

// Anywhere along the side and beyond, however the run lies among the cells.
TEST(LineProfile, LeastDepthOfARunIsABound) {
  std::vector<double> depths;
  for (int k = 0; k < 23; ++k) depths.push_back(1e-6 * ((7 * k) % 23 + 1));
  const LineProfile profile(depths, kLength);
  for (double from = -0.4; from < 0.4; from += 0.0071) {
    for (double to = from; to < 0.45; to += 0.013) {
      double least = profile.eval(to).depth;
      for (double at = from; at < to; at += 0.001) least = std::min(least, profile.eval(at).depth);
      const double bound = profile.least_depth(from, to);
      ASSERT_LE(bound, least * (1.0 + 1e-15)) << from << ' ' << to;
      ASSERT_GE(bound, profile.least_depth());
    }
  }
  EXPECT_EQ(profile.least_depth(-1e9, 1e9), profile.least_depth());
  EXPECT_GT(profile.least_depth(-0.02, 0.02), profile.least_depth()) << "not that of all";
  EXPECT_EQ(LineProfile().least_depth(-0.1, 0.1), 0.0);
}

TEST(LineProfile, UniformDepthIsReproducedAlsoBeyondTheEnds) {
  for (const std::size_t n : {4U, 37U, 1000U}) {
    const LineProfile profile(std::vector<double>(n, 7e-6), kLength);
    for (double position = -0.5; position < 0.5; position += 0.00173) {
      EXPECT_NEAR(profile.eval(position).depth, 7e-6, 7e-6 * 1e-15);  // four weights that sum to one
      EXPECT_NEAR(profile.eval(position).slope, 0.0, 7e-6 * 1e-14 * static_cast<double>(n));
    }
  }
}

// Inside, a lone depth is spread by 1/6, 2/3, 1/6; at an end what goes beyond comes back.
TEST(LineProfile, OneCellSpreadsOverItsNeighboursAndIsMirroredAtTheEnds) {
  constexpr std::size_t kCells = 9;
  constexpr double kWidth = kLength / kCells;
  const auto middle = [](double k) { return (k + 0.5) * kWidth - 0.5 * kLength; };
  for (std::size_t worn = 0; worn < kCells; ++worn) {
    std::vector<double> depths(kCells, 0.0);
    depths[worn] = 1.0;
    const LineProfile profile(depths, kLength);
    for (std::size_t k = 0; k < kCells; ++k) {
      const auto apart = worn > k ? worn - k : k - worn;
      double expected = apart == 0 ? 2.0 / 3.0 : (apart == 1 ? 1.0 / 6.0 : 0.0);
      if (k == worn && (k == 0 || k == kCells - 1)) expected += 1.0 / 6.0;
      EXPECT_NEAR(profile.eval(middle(static_cast<double>(k))).depth, expected, 1e-14) << worn << " at " << k;
    }
  }
}

TEST(LineProfile, SlopeIsTheDerivativeAndZeroAtTheEnds) {
  const LineProfile profile(test::make_depths(23, 1.0, 1), kLength);
  constexpr double kStep = 1e-7;
  for (double position = -0.4; position < 0.4; position += 0.00191) {
    const double difference =
        (profile.eval(position + kStep).depth - profile.eval(position - kStep).depth) / (2.0 * kStep);
    EXPECT_NEAR(profile.eval(position).slope, difference, 1e-5);  // curvatures of 23²/0.6² over the step
  }
  for (const double end : {-0.3, 0.3}) {
    EXPECT_NEAR(profile.eval(end).slope, 0.0, 1e-12);
    EXPECT_EQ(profile.eval(2.0 * end).slope, 0.0);
    EXPECT_NEAR(profile.eval(2.0 * end).depth, profile.eval(end).depth, 1e-14);
  }
}

// Gauss' rule of three points is exact on every span of the cubic, half a cell wide from end to end.
TEST(LineProfile, HoldsTheVolumeOfItsCells) {
  for (const std::size_t n : {4U, 10U, 1000U}) {
    const std::vector<double> depths = test::make_depths(n, 1e-5, 3);
    const LineProfile profile(depths, kLength);
    const double half = 0.25 * kLength / static_cast<double>(n);
    double volume = 0.0;
    for (std::size_t k = 0; k < 2 * n; ++k) {
      const double center = (2.0 * static_cast<double>(k) + 1.0) * half - 0.5 * kLength;
      const double node = std::sqrt(0.6) * half;
      volume += half / 9.0 *
                (5.0 * profile.eval(center - node).depth + 8.0 * profile.eval(center).depth +
                 5.0 * profile.eval(center + node).depth);
    }
    const double cells = std::accumulate(depths.begin(), depths.end(), 0.0) * kLength / static_cast<double>(n);
    EXPECT_NEAR(volume / cells, 1.0, 1e-13);  // sums of up to 6000 terms
  }
}

TEST(LineProfile, StaysWithinItsCellsDepths) {
  const std::vector<double> depths = test::make_depths(31, 1.0, 4);
  const LineProfile profile(depths, kLength);
  EXPECT_EQ(profile.least_depth(), std::ranges::min(depths));
  for (double position = -0.4; position < 0.4; position += 0.00037) {
    EXPECT_GE(profile.eval(position).depth, profile.least_depth());
    EXPECT_LE(profile.eval(position).depth, std::ranges::max(depths));
  }
  EXPECT_TRUE(std::isnan(profile.eval(std::numeric_limits<double>::quiet_NaN()).depth));
}

}  // namespace
}  // namespace gudgeon
