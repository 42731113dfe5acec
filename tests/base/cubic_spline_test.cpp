// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Splines against the curves they must reproduce, finite differences and their order of convergence.
#include "gudgeon/base/cubic_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gudgeon {
namespace {

constexpr double kPi = std::numbers::pi;

const std::vector<double> kUneven{-1.0, -0.7, 0.1, 0.4, 1.3, 2.0};

template <class Curve>
CubicSpline fit(const std::vector<double>& arguments, Curve curve, bool periodic = false) {
  std::vector<double> values;
  for (const double x : arguments) values.push_back(curve(x));
  if (periodic) values.back() = values.front();
  return {arguments, values, periodic};
}

TEST(CubicSpline, PassesThroughItsPoints) {
  const std::vector<double> values{1.0, -2.0, 0.5, 0.5, 7.0, 3.0};
  const CubicSpline spline(kUneven, values, false);
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(spline.eval(kUneven[k]).value, values[k], 1e-14);
}

TEST(CubicSpline, ReproducesACubic) {
  // Without knots at the second points, a cubic is its own spline.
  const CubicSpline spline = fit(kUneven, [](double x) { return 1.0 + x * (-2.0 + x * (0.5 + 3.0 * x)); });
  for (double x = -1.0; x <= 2.0; x += 0.05) {
    const CubicSpline::Value at = spline.eval(x);
    EXPECT_NEAR(at.value, 1.0 + x * (-2.0 + x * (0.5 + 3.0 * x)), 1e-12);
    EXPECT_NEAR(at.slope, -2.0 + x * (1.0 + 9.0 * x), 1e-12);
    EXPECT_NEAR(at.curvature, 1.0 + 18.0 * x, 1e-11);
  }
}

TEST(CubicSpline, IsAParabolaThroughThreeAndALineThroughTwo) {
  const CubicSpline parabola = fit({0.0, 0.5, 2.0}, [](double x) { return 1.0 - x + 2.0 * x * x; });
  const CubicSpline line = fit({1.0, 3.0}, [](double x) { return 4.0 - x; });
  for (const double x : {0.0, 0.2, 0.5, 1.7, 2.0}) {
    EXPECT_NEAR(parabola.eval(x).value, 1.0 - x + 2.0 * x * x, 1e-14);
    EXPECT_NEAR(parabola.eval(x).slope, -1.0 + 4.0 * x, 1e-14);
    EXPECT_NEAR(parabola.eval(x).curvature, 4.0, 1e-14);
  }
  EXPECT_NEAR(line.eval(1.7).value, 2.3, 1e-15);
  EXPECT_NEAR(line.eval(1.7).slope, -1.0, 1e-15);
  EXPECT_EQ(line.eval(1.7).curvature, 0.0);
}

TEST(CubicSpline, IsSmoothAcrossItsPoints) {
  const std::vector<double> values{1.0, -2.0, 0.5, 0.5, 7.0, 1.0};
  for (const bool periodic : {false, true}) {
    const CubicSpline spline(kUneven, values, periodic);
    for (std::size_t k = 1; k + 1 < kUneven.size(); ++k) {
      const CubicSpline::Value below = spline.eval(kUneven[k] - 1e-9);
      const CubicSpline::Value above = spline.eval(kUneven[k] + 1e-9);
      // 2e-9 times derivatives of some hundreds.
      EXPECT_NEAR(below.slope, above.slope, 1e-6);
      EXPECT_NEAR(below.curvature, above.curvature, 1e-5);
    }
  }
}

TEST(CubicSpline, HasTheDerivativesOfItsValue) {
  const CubicSpline spline(kUneven, {1.0, -2.0, 0.5, 0.5, 7.0, 1.0}, true);
  const double h = 1e-5;
  for (double x = -3.05; x < 4.0; x += 0.31) {
    const double slope = (spline.eval(x + h).value - spline.eval(x - h).value) / (2.0 * h);
    const double curvature = (spline.eval(x + h).slope - spline.eval(x - h).slope) / (2.0 * h);
    EXPECT_NEAR(spline.eval(x).slope, slope, 1e-6);
    EXPECT_NEAR(spline.eval(x).curvature, curvature, 1e-5);
  }
}

TEST(CubicSpline, Repeats) {
  const CubicSpline spline(kUneven, {1.0, -2.0, 0.5, 0.5, 7.0, 1.0}, true);
  for (const double x : {-0.9, 0.0, 1.1}) {
    for (const int turns : {-3, 1, 7}) {
      EXPECT_NEAR(spline.eval(x).value, spline.eval(x + 3.0 * turns).value, 1e-12);
      EXPECT_NEAR(spline.eval(x).slope, spline.eval(x + 3.0 * turns).slope, 1e-12);
    }
  }
  // Three points: two unknowns that are each other's neighbours on both sides.
  const CubicSpline three({0.0, 0.4, 1.0}, {1.0, 2.0, 1.0}, true);
  EXPECT_NEAR(three.eval(1e-9).slope, three.eval(1.0 - 1e-9).slope, 1e-6);
  EXPECT_NEAR(three.eval(1e-9).curvature, three.eval(1.0 - 1e-9).curvature, 1e-5);
}

TEST(CubicSpline, HoldsItsEnds) {
  const CubicSpline spline(kUneven, {1.0, -2.0, 0.5, 0.5, 7.0, 3.0}, false);
  EXPECT_EQ(spline.eval(-5.0).value, 1.0);
  EXPECT_EQ(spline.eval(5.0).value, 3.0);
  EXPECT_EQ(spline.eval(5.0).slope, 0.0);
  EXPECT_EQ(spline.eval(5.0).curvature, 0.0);
  EXPECT_EQ(spline.eval(2.0).value, 3.0);
  EXPECT_TRUE(std::isnan(spline.eval(std::nan("")).value));
}

TEST(CubicSpline, ConvergesWithFourthOrder) {
  const auto error = [](int n, bool periodic) {
    std::vector<double> arguments;
    for (int k = 0; k <= n; ++k) arguments.push_back(2.0 * kPi * k / n);
    const CubicSpline spline = fit(
        arguments, [](double x) { return std::sin(x + 0.3); }, periodic);
    double worst = 0.0;
    for (double x = 0.0; x < 2.0 * kPi; x += 0.001) {
      worst = std::max(worst, std::abs(spline.eval(x).value - std::sin(x + 0.3)));
    }
    return worst;
  };
  for (const bool periodic : {false, true}) {
    // Order 4 within a tenth, which 40 and 80 points of a sine leave of higher terms.
    EXPECT_NEAR(std::log2(error(40, periodic) / error(80, periodic)), 4.0, periodic ? 0.1 : 0.5);
  }
}

}  // namespace
}  // namespace gudgeon
