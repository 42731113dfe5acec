// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One span of the uniform cubic B-spline, shared by the wear profiles of circles and lines.
#pragma once

namespace gudgeon {

/// Value and slope (per span) between the second and the third of four neighbouring coefficients.
struct SplineValue {
  double value;
  double slope;
};

/// share f in [0, 1] of the span from coefficient h[1] to h[2].
inline SplineValue eval_uniform_spline(const double* h, double f) noexcept {
  const double g = 1.0 - f;
  const double f2 = f * f;
  const double g2 = g * g;
  const double value = (h[0] * g2 * g + h[1] * (4.0 - 6.0 * f2 + 3.0 * f2 * f) +
                        h[2] * (4.0 - 6.0 * g2 + 3.0 * g2 * g) + h[3] * f2 * f) *
                       (1.0 / 6.0);
  const double slope = 0.5 * (-h[0] * g2 + h[1] * (3.0 * f2 - 4.0 * f) - h[2] * (3.0 * g2 - 4.0 * g) + h[3] * f2);
  return {value, slope};
}

}  // namespace gudgeon
