// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Waves and cubics by their formulas.
#include "tests/oracle/driver_motion.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace gudgeon::oracle {

namespace {

constexpr const char* kWaveText = "a + c*t + b*sin(w*t + p)";

TextbookMotion eval_wave(const Expression& expression, double time) {
  if (expression.text != kWaveText) throw std::runtime_error("oracle: no derivatives of " + expression.text);
  const auto constant = [&](std::size_t k) { return expression.constants.at(k).second; };
  const double a = constant(0), b = constant(1), c = constant(2), w = constant(3), p = constant(4);
  return {a + c * time + b * std::sin(w * time + p), c + b * w * std::cos(w * time + p),
          -b * w * w * std::sin(w * time + p)};
}

/// Newton's form of the cubic through the first four points, and its derivatives by the product rule.
TextbookMotion eval_cubic(const SampledCurve& curve, double time) {
  std::array<double, 4> difference{};
  for (std::size_t k = 0; k < 4; ++k) difference[k] = curve.values.at(k);
  for (std::size_t order = 1; order < 4; ++order) {
    for (std::size_t k = 3; k >= order; --k) {
      difference[k] = (difference[k] - difference[k - 1]) / (curve.arguments[k] - curve.arguments[k - order]);
    }
  }
  TextbookMotion at{difference[3], 0.0, 0.0};
  for (std::size_t k = 3; k-- > 0;) {
    const double x = time - curve.arguments[k];
    at = {difference[k] + x * at.value, at.value + x * at.rate, 2.0 * at.rate + x * at.acceleration};
  }
  return at;
}

}  // namespace

Expression make_wave(const Wave& wave) {
  return {kWaveText, {{"a", wave.a}, {"b", wave.b}, {"c", wave.c}, {"w", wave.w}, {"p", wave.p}}};
}

SampledCurve make_cubic_curve(double c0, double c1, double c2, double c3) {
  SampledCurve curve;
  for (int k = 0; k <= 12; ++k) {
    const double t = -0.5 + (k + 0.2 * (k % 3)) / 6.0;
    curve.arguments.push_back(t);
    curve.values.push_back(c0 + t * (c1 + t * (c2 + t * c3)));
  }
  return curve;
}

TextbookMotion eval_motion(const Driver& driver, double time) {
  if (const auto* expression = std::get_if<Expression>(&driver.motion)) return eval_wave(*expression, time);
  if (const auto* curve = std::get_if<SampledCurve>(&driver.motion)) return eval_cubic(*curve, time);
  return {driver.start + driver.speed * time, driver.speed, 0.0};
}

}  // namespace gudgeon::oracle
