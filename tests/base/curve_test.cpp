// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Splines against the curves they must reproduce, finite differences and their order of convergence; the shape that
// monotone curves keep; where the pieces of every kind meet.
#include "gudgeon/base/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gudgeon {
namespace {

constexpr double kPi = std::numbers::pi;

const std::vector<double> kUneven{-1.0, -0.7, 0.1, 0.4, 1.3, 2.0};

template <class Shape>
Curve fit(const std::vector<double>& arguments, Shape curve, bool periodic = false) {
  std::vector<double> values;
  for (const double x : arguments) values.push_back(curve(x));
  if (periodic) values.back() = values.front();
  return {arguments, values, periodic, Interpolation::spline};
}

TEST(CurveSpline, PassesThroughItsPoints) {
  const std::vector<double> values{1.0, -2.0, 0.5, 0.5, 7.0, 3.0};
  const Curve spline(kUneven, values, false, Interpolation::spline);
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(spline.eval(kUneven[k]).value, values[k], 1e-14);
}

TEST(CurveSpline, ReproducesACubic) {
  // Without knots at the second points, a cubic is its own spline.
  const Curve spline = fit(kUneven, [](double x) { return 1.0 + x * (-2.0 + x * (0.5 + 3.0 * x)); });
  for (double x = -1.0; x <= 2.0; x += 0.05) {
    const Curve::Value at = spline.eval(x);
    EXPECT_NEAR(at.value, 1.0 + x * (-2.0 + x * (0.5 + 3.0 * x)), 1e-12);
    EXPECT_NEAR(at.slope, -2.0 + x * (1.0 + 9.0 * x), 1e-12);
    EXPECT_NEAR(at.curvature, 1.0 + 18.0 * x, 1e-11);
  }
}

TEST(CurveSpline, IsAParabolaThroughThreeAndALineThroughTwo) {
  const Curve parabola = fit({0.0, 0.5, 2.0}, [](double x) { return 1.0 - x + 2.0 * x * x; });
  const Curve line = fit({1.0, 3.0}, [](double x) { return 4.0 - x; });
  for (const double x : {0.0, 0.2, 0.5, 1.7, 2.0}) {
    EXPECT_NEAR(parabola.eval(x).value, 1.0 - x + 2.0 * x * x, 1e-14);
    EXPECT_NEAR(parabola.eval(x).slope, -1.0 + 4.0 * x, 1e-14);
    EXPECT_NEAR(parabola.eval(x).curvature, 4.0, 1e-14);
  }
  EXPECT_NEAR(line.eval(1.7).value, 2.3, 1e-15);
  EXPECT_NEAR(line.eval(1.7).slope, -1.0, 1e-15);
  EXPECT_EQ(line.eval(1.7).curvature, 0.0);
}

TEST(CurveSpline, IsSmoothAcrossItsPoints) {
  const std::vector<double> values{1.0, -2.0, 0.5, 0.5, 7.0, 1.0};
  for (const bool periodic : {false, true}) {
    const Curve spline(kUneven, values, periodic, Interpolation::spline);
    for (std::size_t k = 1; k + 1 < kUneven.size(); ++k) {
      const Curve::Value below = spline.eval(kUneven[k] - 1e-9);
      const Curve::Value above = spline.eval(kUneven[k] + 1e-9);
      // 2e-9 times derivatives of some hundreds.
      EXPECT_NEAR(below.slope, above.slope, 1e-6);
      EXPECT_NEAR(below.curvature, above.curvature, 1e-5);
    }
  }
}

TEST(CurveSpline, HasTheDerivativesOfItsValue) {
  const Curve spline(kUneven, {1.0, -2.0, 0.5, 0.5, 7.0, 1.0}, true, Interpolation::spline);
  const double h = 1e-5;
  for (double x = -3.05; x < 4.0; x += 0.31) {
    const double slope = (spline.eval(x + h).value - spline.eval(x - h).value) / (2.0 * h);
    const double curvature = (spline.eval(x + h).slope - spline.eval(x - h).slope) / (2.0 * h);
    EXPECT_NEAR(spline.eval(x).slope, slope, 1e-6);
    EXPECT_NEAR(spline.eval(x).curvature, curvature, 1e-5);
  }
}

TEST(CurveSpline, Repeats) {
  const Curve spline(kUneven, {1.0, -2.0, 0.5, 0.5, 7.0, 1.0}, true, Interpolation::spline);
  for (const double x : {-0.9, 0.0, 1.1}) {
    for (const int turns : {-3, 1, 7}) {
      EXPECT_NEAR(spline.eval(x).value, spline.eval(x + 3.0 * turns).value, 1e-12);
      EXPECT_NEAR(spline.eval(x).slope, spline.eval(x + 3.0 * turns).slope, 1e-12);
    }
  }
  // Three points: two unknowns that are each other's neighbours on both sides.
  const Curve three({0.0, 0.4, 1.0}, {1.0, 2.0, 1.0}, true, Interpolation::spline);
  EXPECT_NEAR(three.eval(1e-9).slope, three.eval(1.0 - 1e-9).slope, 1e-6);
  EXPECT_NEAR(three.eval(1e-9).curvature, three.eval(1.0 - 1e-9).curvature, 1e-5);
}

TEST(CurveSpline, HoldsItsEnds) {
  const Curve spline(kUneven, {1.0, -2.0, 0.5, 0.5, 7.0, 3.0}, false, Interpolation::spline);
  EXPECT_EQ(spline.eval(-5.0).value, 1.0);
  EXPECT_EQ(spline.eval(5.0).value, 3.0);
  EXPECT_EQ(spline.eval(5.0).slope, 0.0);
  EXPECT_EQ(spline.eval(5.0).curvature, 0.0);
  EXPECT_EQ(spline.eval(2.0).value, 3.0);
  EXPECT_TRUE(std::isnan(spline.eval(std::nan("")).value));
}

TEST(CurveSpline, ConvergesWithFourthOrder) {
  const auto error = [](int n, bool periodic) {
    std::vector<double> arguments;
    for (int k = 0; k <= n; ++k) arguments.push_back(2.0 * kPi * k / n);
    const Curve spline = fit(
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

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

TEST(CurveMonotone, StaysBetweenNeighbouringPoints) {
  // A spline through these swings to -1.7 and 21.7.
  const std::vector<double> arguments{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 5.5, 9.0};
  const std::vector<double> values{0.0, 0.0, 0.0, 20.0, 20.0, 20.0, -3.0, 4.0};
  const Curve curve(arguments, values, false, Interpolation::monotone);
  for (std::size_t k = 0; k + 1 < arguments.size(); ++k) {
    const auto [low, high] = std::minmax(values[k], values[k + 1]);
    for (int i = 0; i <= 100; ++i) {
      const double value = curve.eval(arguments[k] + (arguments[k + 1] - arguments[k]) * i / 100.0).value;
      EXPECT_GE(value, low - 1e-14);
      EXPECT_LE(value, high + 1e-14);
    }
  }
  EXPECT_EQ(curve.eval(0.5).value, 0.0);
  EXPECT_EQ(curve.eval(4.5).value, 20.0);
}

TEST(CurveMonotone, HasTheSlopesOfFritschAndButland) {
  // Weighted harmonic mean of the neighbouring chords 1 and 4 over widths 1 and 2: (w1 + w2)/(w1/1 + w2/4), w1 = 2*2 +
  // 1, w2 = 2 + 2*1.
  const Curve curve({0.0, 1.0, 3.0, 4.0}, {0.0, 1.0, 9.0, 5.0}, false, Interpolation::monotone);
  EXPECT_NEAR(curve.eval(1.0).slope, 9.0 / (5.0 / 1.0 + 4.0 / 4.0), 1e-13);
  EXPECT_NEAR(curve.eval(3.0).slope, 0.0, 1e-13);  // a summit
  EXPECT_NEAR(curve.eval(0.0).slope, 1.0, 1e-13);
  EXPECT_NEAR(curve.eval(4.0).slope, -4.0, 1e-13);
}

TEST(CurveMonotone, IsALineThroughTwoPointsAndRepeats) {
  const Curve line({1.0, 3.0}, {4.0, 8.0}, false, Interpolation::monotone);
  EXPECT_DOUBLE_EQ(line.eval(1.5).value, 5.0);
  const Curve wave({0.0, 0.4, 1.0}, {1.0, 2.0, 1.0}, true, Interpolation::monotone);
  for (const double x : {-0.3, 0.2, 0.4, 0.95}) EXPECT_NEAR(wave.eval(x).value, wave.eval(x + 3.0).value, 1e-14);
  EXPECT_NEAR(wave.eval(0.0).slope, 0.0, 1e-14);  // lowest point, in the middle of its neighbours
}

TEST(CurveLinear, IsStraightBetweenPoints) {
  const Curve curve({0.0, 1.0, 3.0}, {0.0, 2.0, -2.0}, false, Interpolation::linear);
  EXPECT_DOUBLE_EQ(curve.eval(0.25).value, 0.5);
  EXPECT_DOUBLE_EQ(curve.eval(2.5).value, -1.0);
  EXPECT_DOUBLE_EQ(curve.eval(2.5).slope, -2.0);
  EXPECT_EQ(curve.eval(2.5).curvature, 0.0);
  EXPECT_EQ(curve.eval(7.0).value, -2.0);
}

TEST(Curve, HasTheDerivativesOfItsValueInEveryKind) {
  const double h = 1e-5;
  for (const auto kind : {Interpolation::linear, Interpolation::monotone, Interpolation::spline}) {
    const Curve curve(kUneven, {1.0, -2.0, 0.5, 0.5, 7.0, 1.0}, true, kind);
    for (double x = -3.05; x < 4.0; x += 0.31) {
      EXPECT_NEAR(curve.eval(x).slope, (curve.eval(x + h).value - curve.eval(x - h).value) / (2.0 * h), 1e-6);
      EXPECT_NEAR(curve.eval(x).curvature, (curve.eval(x + h).slope - curve.eval(x - h).slope) / (2.0 * h), 1e-5);
    }
  }
}

TEST(Curve, GoesOnAtItsPointsAsItsKindSays) {
  const std::vector<double> values{1.0, -2.0, 0.5, 3.5, 7.0, 1.0};
  for (const auto kind : {Interpolation::linear, Interpolation::monotone, Interpolation::spline}) {
    const Curve curve(kUneven, values, true, kind);
    for (const double x : kUneven) {
      const Curve::Value below = curve.eval(x - 1e-10);
      const Curve::Value above = curve.eval(x + 1e-10);
      EXPECT_NEAR(below.value, above.value, 1e-7);
      if (kind != Interpolation::linear) {
        EXPECT_NEAR(below.slope, above.slope, 1e-6);
      }
      if (kind == Interpolation::spline) {
        EXPECT_NEAR(below.curvature, above.curvature, 1e-5);
      }
    }
  }
}

TEST(Curve, TellsThePieceOfAnArgument) {
  const Curve curve(kUneven, {1.0, -2.0, 0.5, 3.5, 7.0, 1.0}, false, Interpolation::monotone);
  EXPECT_EQ(curve.find_piece(0.2).first, 0.1);
  EXPECT_EQ(curve.find_piece(0.2).second, 0.4);
  EXPECT_EQ(curve.find_piece(0.4).first, 0.4);
  EXPECT_EQ(curve.find_piece(-1.5).first, -kUnbounded);
  EXPECT_EQ(curve.find_piece(-1.5).second, -1.0);
  EXPECT_EQ(curve.find_piece(2.0).first, 2.0);
  EXPECT_EQ(curve.find_piece(2.0).second, kUnbounded);
  const Curve wave(kUneven, {1.0, -2.0, 0.5, 3.5, 7.0, 1.0}, true, Interpolation::spline);
  EXPECT_NEAR(wave.find_piece(-5.8).first, -5.9, 1e-14);
  EXPECT_NEAR(wave.find_piece(-5.8).second, -5.6, 1e-14);
  EXPECT_EQ(wave.find_piece(2.0).first, 2.0);
  EXPECT_NEAR(wave.find_piece(2.0).second, 2.3, 1e-14);
}

}  // namespace
}  // namespace gudgeon
