// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Waves by their formula, curves by the textbook's.
#include "tests/oracle/driver_motion.h"

#include <cmath>
#include <stdexcept>

#include "tests/oracle/textbook_curves.h"

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
  if (const auto* curve = std::get_if<SampledCurve>(&driver.motion)) {
    const TextbookValue at = TextbookCurve::of_motion(*curve).eval(time);
    return {at.value, at.slope, at.curvature};
  }
  return {driver.start + driver.speed * time, driver.speed, 0.0};
}

}  // namespace gudgeon::oracle
