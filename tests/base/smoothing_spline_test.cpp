// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What smoothing leaves of waves, parabolas and noise, and how far it is from its points.
#include "gudgeon/base/smoothing_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace gudgeon {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

struct Samples {
  std::vector<double> x;
  std::vector<double> y;
  [[nodiscard]] MeasuredPoints points(bool periodic = false) const { return {x, y, periodic}; }
};

template <class Shape>
Samples sample(int n, double length, Shape curve) {
  Samples samples;
  for (int k = 0; k <= n; ++k) {
    samples.x.push_back(length * k / n);
    samples.y.push_back(curve(samples.x.back()));
  }
  return samples;
}

/// Amplitude of the wave of that frequency in the curve, by its Fourier integral over whole waves in the middle.
double find_amplitude(const Curve& curve, double frequency, double from, int n_waves) {
  constexpr int kSteps = 4000;
  double sine = 0.0;
  double cosine = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = n_waves / frequency * i / kSteps;
    const double value = curve.eval(from + t).value;
    sine += 2.0 / kSteps * value * std::sin(kTurn * frequency * t);
    cosine += 2.0 / kSteps * value * std::cos(kTurn * frequency * t);
  }
  return std::hypot(sine, cosine);
}

TEST(SmoothingSpline, LeavesOfAWaveWhatItsFrequencyAllows) {
  for (const double ratio : {0.5, 1.0, 2.0}) {
    const double cut_off = 20.0;
    const double frequency = ratio * cut_off;
    const Samples wave = sample(2000, 2.0, [&](double t) { return std::sin(kTurn * frequency * t); });
    const SmoothedCurve smooth = smooth_at(wave.points(), cut_off);
    // With 16 knots a wave the penalty is 1.3 % off at the cut-off, which is 0.3 % of the wave.
    EXPECT_NEAR(find_amplitude(smooth.curve, frequency, 0.5, 10), 1.0 / (1.0 + std::pow(ratio, 6)), 4e-3) << ratio;
  }
}

TEST(SmoothingSpline, DoesNotDependOnHowDenselyAWaveIsSampled) {
  const auto wave = [](double t) { return std::sin(kTurn * 10.0 * t); };
  const Samples even = sample(1000, 1.0, wave);
  Samples uneven;
  for (int k = 0; k <= 1400; ++k) {
    const double s = k / 1400.0;
    uneven.x.push_back(s + 0.1 * std::sin(kTurn * s) / kTurn);
    uneven.y.push_back(wave(uneven.x.back()));
  }
  uneven.x.back() = 1.0;
  const Curve one = smooth_at(even.points(), 10.0).curve;
  const Curve two = smooth_at(uneven.points(), 10.0).curve;
  for (double t = 0.2; t < 0.8; t += 0.01) EXPECT_NEAR(one.eval(t).value, two.eval(t).value, 1e-3);
}

TEST(SmoothingSpline, KeepsParabolasUpToTheirEnds) {
  const Samples parabola = sample(500, 2.0, [](double t) { return 3.0 - 2.0 * t + 2.5 * t * t; });
  for (const double cut_off : {0.1, 1.0, 30.0}) {
    const SmoothedCurve smooth = smooth_at(parabola.points(), cut_off);
    EXPECT_LT(smooth.distance, 1e-9);
    for (const double t : {0.0, 0.3, 1.999, 2.0}) EXPECT_NEAR(smooth.curve.eval(t).curvature, 5.0, 1e-4) << cut_off;
  }
}

TEST(SmoothingSpline, FindsTheAccelerationUnderAnEncodersCounts) {
  // 2000 samples a millisecond apart of an angle that 10 000 counts a turn tell; it speeds up with 5 rad/s².
  const double count = kTurn / 10000.0;
  const Samples measured =
      sample(1999, 1.999, [&](double t) { return count * std::round((3.0 * t + 2.5 * t * t) / count); });
  const Curve exact(measured.x, measured.y, false, Interpolation::spline);
  const SmoothedCurve smooth = smooth_at(measured.points(), 2.0);
  double rough = 0.0;
  for (const double t : measured.x) {
    rough = std::max(rough, std::abs(exact.eval(t).curvature));
    EXPECT_NEAR(smooth.curve.eval(t).curvature, 5.0, 0.5);
    EXPECT_NEAR(smooth.curve.eval(t).value, 3.0 * t + 2.5 * t * t, count);
  }
  EXPECT_GT(rough, 1000.0);
  EXPECT_NEAR(smooth.distance, count / std::sqrt(12.0), 0.05 * count);
}

TEST(SmoothingSpline, IsTheSmoothestWithinATolerance) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.01);
  const Samples measured = sample(1500, 3.0, [&](double t) { return std::sin(kTurn * t) + noise(random); });
  const SmoothedCurve smooth = smooth_within(measured.points(), 0.01);
  EXPECT_LE(smooth.distance, 0.01);
  EXPECT_GT(smooth.distance, 0.00999);
  EXPECT_GT(smooth_at(measured.points(), 0.99 * smooth.frequency).distance, 0.01);
  for (double t = 0.1; t < 2.9; t += 0.1) EXPECT_NEAR(smooth.curve.eval(t).value, std::sin(kTurn * t), 0.01);
  // Nothing smooth is as near as this.
  EXPECT_GT(smooth_within(measured.points(), 1e-6).distance, 1e-6);
}

TEST(SmoothingSpline, GoesOnSmoothlyIntoTheNextPeriod) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.02);
  Samples measured = sample(300, 1.0, [&](double t) { return std::cos(kTurn * t) + noise(random); });
  measured.y.back() = measured.y.front();
  const Curve curve = smooth_at(measured.points(true), 3.0).curve;
  EXPECT_TRUE(curve.is_periodic());
  EXPECT_NEAR(curve.eval(1.0 - 1e-9).value, curve.eval(0.0).value, 1e-6);
  EXPECT_NEAR(curve.eval(1.0 - 1e-9).slope, curve.eval(0.0).slope, 1e-5);
  EXPECT_NEAR(curve.eval(1.0 - 1e-9).curvature, curve.eval(0.0).curvature, 1e-4);
  for (double t = 0.0; t < 1.0; t += 0.05) EXPECT_NEAR(curve.eval(t).value, std::cos(kTurn * t), 0.02);
}

}  // namespace
}  // namespace gudgeon
