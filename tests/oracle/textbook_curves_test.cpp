// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The textbook's curves, where they are known, and beside the engine's.
#include "tests/oracle/textbook_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gudgeon::oracle {
namespace {

SampledCurve draw_curve(std::mt19937& random, bool periodic, Interpolation interpolation) {
  std::uniform_real_distribution<double> step(0.05, 1.0);
  std::uniform_real_distribution<double> value(-3.0, 3.0);
  SampledCurve curve;
  for (double x = -1.0; curve.arguments.size() < 8; x += step(random)) {
    curve.arguments.push_back(x);
    curve.values.push_back(value(random));
  }
  curve.periodic = periodic;
  if (periodic) curve.values.back() = curve.values.front();
  curve.interpolation = interpolation;
  return curve;
}

TEST(TextbookCurve, IsTheCubicThatItsPointsLieOn) {
  SampledCurve curve;
  const auto cubic = [](double x) { return 1.0 + x * (-2.0 + x * (0.5 + 3.0 * x)); };
  for (const double x : {-1.0, -0.7, 0.1, 0.4, 1.3, 2.0}) {
    curve.arguments.push_back(x);
    curve.values.push_back(cubic(x));
  }
  const TextbookCurve spline = TextbookCurve::of_motion(curve);
  for (double x = -0.95; x < 2.0; x += 0.1) {
    EXPECT_NEAR(spline.eval(x).value, cubic(x), 1e-12);
    EXPECT_NEAR(spline.eval(x).slope, -2.0 + x + 9.0 * x * x, 1e-12);
    EXPECT_NEAR(spline.eval(x).curvature, 1.0 + 18.0 * x, 1e-11);
  }
  // ∫ from −1 to 2, and one more on either side at the end values
  EXPECT_NEAR(spline.integrate(-1.0, 2.0), 3.0 - 3.0 + 1.5 + 11.25, 1e-12);
  EXPECT_NEAR(spline.integrate(-2.0, 3.0), 12.75 + cubic(-1.0) + cubic(2.0), 1e-12);
}

TEST(TextbookCurve, IsTheEnginesWhicheverWayItRuns) {
  std::mt19937 random(7);
  for (int k = 0; k < 60; ++k) {
    const auto interpolation = kInterpolations[static_cast<std::size_t>(k) % 3].second;
    const SampledCurve drawn = draw_curve(random, k % 2 == 0, interpolation);
    const TextbookCurve ours(drawn, interpolation);
    const Curve engines(drawn.arguments, drawn.values, drawn.periodic, interpolation);
    double sum = 0.0;
    constexpr int kPoints = 4000;
    const double width = 8.0 / kPoints;
    for (int i = 0; i < kPoints; ++i) {
      const double x = -2.0 + (i + 0.5) * width;
      const Curve::Value expected = engines.eval(x);
      const TextbookValue found = ours.eval(x);
      ASSERT_NEAR(found.value, expected.value, 1e-11) << kInterpolations[static_cast<std::size_t>(k) % 3].first << x;
      ASSERT_NEAR(found.slope, expected.slope, 1e-9);
      ASSERT_NEAR(found.curvature, expected.curvature, 1e-8 * (1.0 + std::abs(expected.curvature)));
      sum += found.value * width;
    }
    EXPECT_NEAR(ours.integrate(-2.0, 6.0), sum, 1e-2) << "the middles' rule, off at points by h times the slope";
  }
}

TEST(TextbookCurve, IntegratesWhatItIs) {
  std::mt19937 random(11);
  for (int k = 0; k < 30; ++k) {
    const auto interpolation = kInterpolations[static_cast<std::size_t>(k) % 3].second;
    const TextbookCurve curve(draw_curve(random, k % 2 == 0, interpolation), interpolation);
    for (double x = -3.0; x < 8.0; x += 0.137) {
      constexpr double kStep = 1e-5;
      const double slope = curve.integrate(x - kStep, x + kStep) / (2.0 * kStep);
      EXPECT_NEAR(slope, curve.eval(x).value, 1e-3);
    }
  }
}

}  // namespace
}  // namespace gudgeon::oracle
