// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The B-spline of wear depths: where depth goes, what it conserves, how smooth it is, and any angle at all.
#include "gudgeon/geometry/radial_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace gudgeon {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

std::vector<double> make_random_depths(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.2, 1.0);
  std::vector<double> depths(n);
  for (double& depth : depths) depth = uniform(random);
  return depths;
}

double find_center(std::size_t cell, std::size_t n) {
  return kFullTurn * (static_cast<double>(cell) + 0.5) / static_cast<double>(n);
}

TEST(RadialProfile, UnwornIsZeroEverywhere) {
  for (const RadialProfile& profile : {RadialProfile(), RadialProfile(std::vector<double>(8, 0.0))}) {
    EXPECT_FALSE(profile.is_worn());
    EXPECT_EQ(profile.least_depth(), 0.0);
    for (const double angle : {0.0, -3.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
      EXPECT_EQ(profile.eval(angle).depth, 0.0);
      EXPECT_EQ(profile.eval(angle).slope, 0.0);
    }
  }
}

// Over any run, also across the seam, of more than a turn, and of angles of many turns.
TEST(RadialProfile, LeastDepthOfARunIsABound) {
  const RadialProfile profile(make_random_depths(29, 5));
  for (double from = -14.0; from < 14.0; from += 0.173) {
    for (double to = from; to < from + 7.0; to += 0.31) {
      double least = profile.eval(to).depth;
      for (double at = from; at < to; at += 0.02) least = std::min(least, profile.eval(at).depth);
      const double bound = profile.least_depth(from, to);
      ASSERT_LE(bound, least * (1.0 + 1e-15)) << from << ' ' << to;
      ASSERT_GE(bound, profile.least_depth());
    }
  }
  EXPECT_EQ(profile.least_depth(0.0, 1e300), profile.least_depth());
  EXPECT_EQ(RadialProfile().least_depth(0.0, 1.0), 0.0);
  // One cell below the others counts for what it reaches, two cells to either side.
  std::vector<double> depths(100, 2e-6);
  depths[40] = 1e-6;
  const RadialProfile lone(depths);
  EXPECT_EQ(lone.least_depth(find_center(38, 100) - 0.2, find_center(38, 100) - 1e-9), 2e-6);
  EXPECT_EQ(lone.least_depth(find_center(38, 100) + 1e-9, find_center(39, 100)), 1e-6);
  EXPECT_EQ(lone.least_depth(find_center(42, 100) + 1e-9, find_center(45, 100)), 2e-6);
}

TEST(RadialProfile, UniformDepthIsReproduced) {
  for (const std::size_t n : {4u, 37u, 1000u}) {
    const RadialProfile profile(std::vector<double>(n, 7e-6));
    EXPECT_TRUE(profile.is_worn());
    EXPECT_EQ(profile.least_depth(), 7e-6);
    for (double angle = -9.0; angle < 9.0; angle += 0.0173) {
      const auto [depth, slope] = profile.eval(angle);
      EXPECT_NEAR(depth, 7e-6, 7e-6 * 1e-15);  // four weights that sum to one
      // The slope is a difference of such weights over one cell's angle.
      EXPECT_NEAR(slope, 0.0, 7e-6 * 1e-15 * static_cast<double>(n));
    }
  }
}

// Catches every shift of the cells, at the seam as well: B₃ is 2/3 at its own centre, 1/6 at the neighbours', 23/48
// at its own edges, 1/48 at the neighbours' far edges, nothing two cells away.
TEST(RadialProfile, OneCellSpreadsOverItsNeighboursOnly) {
  constexpr std::size_t kCells = 9;
  constexpr double kWidth = kFullTurn / kCells;
  for (const std::size_t worn : {0u, 1u, 4u, 7u, 8u}) {
    std::vector<double> depths(kCells, 0.0);
    depths[worn] = 1.0;
    const RadialProfile profile(depths);
    const double center = find_center(worn, kCells);
    const double tolerance = 1e-14;  // rounding of the wrapped position, a few parts in 1e16 of nine cells
    EXPECT_NEAR(profile.eval(center).depth, 2.0 / 3.0, tolerance);
    EXPECT_NEAR(profile.eval(center).slope, 0.0, tolerance / kWidth);
    for (const double side : {-1.0, 1.0}) {
      EXPECT_NEAR(profile.eval(center + 0.5 * side * kWidth).depth, 23.0 / 48.0, tolerance);
      EXPECT_NEAR(profile.eval(center + side * kWidth).depth, 1.0 / 6.0, tolerance);
      EXPECT_NEAR(profile.eval(center + side * kWidth).slope, -side * 0.5 / kWidth, tolerance / kWidth);
      EXPECT_NEAR(profile.eval(center + 1.5 * side * kWidth).depth, 1.0 / 48.0, tolerance);
      EXPECT_NEAR(profile.eval(center + 2.0 * side * kWidth).depth, 0.0, tolerance);
      EXPECT_NEAR(profile.eval(center + 3.3 * side * kWidth).depth, 0.0, tolerance);
    }
  }
}

TEST(RadialProfile, SlopeIsTheDerivative) {
  const RadialProfile profile(make_random_depths(23, 1));
  constexpr double kStep = 1e-6;
  for (double angle = -7.0; angle < 7.0; angle += 0.0191) {
    const double difference = (profile.eval(angle + kStep).depth - profile.eval(angle - kStep).depth) / (2.0 * kStep);
    EXPECT_NEAR(profile.eval(angle).slope, difference, 2e-9);  // rounding of depths of order 1 over the step
  }
}

TEST(RadialProfile, IsTwiceContinuouslyDifferentiableOverEveryKnot) {
  constexpr std::size_t kCells = 12;
  const RadialProfile profile(make_random_depths(kCells, 2));
  constexpr double kStep = 1e-5;
  for (std::size_t k = 0; k < kCells; ++k) {
    const double knot = find_center(k, kCells);
    const auto before = profile.eval(knot - kStep);
    const auto at = profile.eval(knot);
    const auto after = profile.eval(knot + kStep);
    EXPECT_NEAR(before.depth, after.depth, 1e-4) << k;  // slopes are below 2 here
    // A jump of the second derivative would be of the order of itself, (12/2π)² = 3.6; its change over a step is 1e-3.
    EXPECT_NEAR((at.slope - before.slope) / kStep, (after.slope - at.slope) / kStep, 5e-3) << k;
  }
}

TEST(RadialProfile, HoldsTheVolumeOfItsCells) {
  for (const std::size_t n : {4u, 10u, 1000u}) {
    const std::vector<double> depths = make_random_depths(n, 3);
    const RadialProfile profile(depths);
    const double width = kFullTurn / static_cast<double>(n);
    double integral = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      // Simpson's rule is exact for the cubic between two knots.
      const double from = find_center(k, n);
      integral +=
          width / 6.0 *
          (profile.eval(from).depth + 4.0 * profile.eval(from + 0.5 * width).depth + profile.eval(from + width).depth);
    }
    const double expected = width * std::accumulate(depths.begin(), depths.end(), 0.0);
    EXPECT_NEAR(integral, expected, 1e-13 * expected) << n;  // sums of n rounded terms
  }
}

TEST(RadialProfile, StaysWithinItsCellDepths) {
  std::vector<double> depths = make_random_depths(17, 4);
  depths[5] = -0.3;
  const RadialProfile profile(depths);
  const auto [least, most] = std::ranges::minmax(depths);
  EXPECT_EQ(profile.least_depth(), -0.3);
  for (double angle = 0.0; angle < kFullTurn; angle += 1e-3) {
    const double depth = profile.eval(angle).depth;
    EXPECT_GE(depth, least);
    EXPECT_LE(depth, most);
  }
}

TEST(RadialProfile, RepeatsEveryTurn) {
  const RadialProfile profile(make_random_depths(31, 5));
  for (const double turns : {-1000.0, -3.0, -1.0, 1.0, 2.0, 1e6}) {
    for (double angle = 0.05; angle < kFullTurn; angle += 0.4) {
      // Slopes are below 10 per radian; the sum itself rounds to a part in 1e16.
      EXPECT_NEAR(profile.eval(angle + turns * kFullTurn).depth, profile.eval(angle).depth,
                  1e-14 + std::abs(turns) * kFullTurn * 1e-15 * 10.0);
    }
  }
}

TEST(RadialProfile, HasNoStepAtTheSeamOrWhereWrappingRounds) {
  const RadialProfile profile(make_random_depths(8, 6));
  const double knot = find_center(0, 8);
  EXPECT_NEAR(profile.eval(std::nextafter(knot, 0.0)).depth, profile.eval(knot).depth, 1e-14);
  EXPECT_NEAR(profile.eval(std::nextafter(knot, 1.0)).depth, profile.eval(knot).depth, 1e-14);
  EXPECT_NEAR(profile.eval(-1e-20).depth, profile.eval(0.0).depth, 1e-14);
  EXPECT_NEAR(profile.eval(std::nextafter(kFullTurn, 0.0)).depth, profile.eval(0.0).depth, 1e-14);
}

TEST(RadialProfile, TellsWhenAnAngleHasNoPlace) {
  const RadialProfile profile(make_random_depths(8, 7));
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double angle : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite}) {
    EXPECT_TRUE(std::isnan(profile.eval(angle).depth)) << angle;
    EXPECT_TRUE(std::isnan(profile.eval(angle).slope)) << angle;
  }
  for (const double angle : {1e300, -1e300, 1e18, -1e18, 1.7e308}) {
    const double depth = profile.eval(angle).depth;
    EXPECT_TRUE(std::isnan(depth) || (depth >= 0.2 && depth <= 1.0)) << angle;
  }
}

}  // namespace
}  // namespace gudgeon
