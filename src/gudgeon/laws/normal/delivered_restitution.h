// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The restitution that a dissipative contact law really delivers, whatever it was asked for.
#pragma once

#include <algorithm>
#include <cmath>

namespace gudgeon {

/// e_out, the root in (0, 1] of χ (1 + e_out) = ln[(1 + χ)/(1 − χ e_out)]
///
/// χ [1] damping factor of F = K δⁿ (1 + χ δ̇/δ̇₀), >= 0. Holds for every stiffness, mass, exponent and onset speed.
/// χ → 0: e_out → 1 − 2χ/3; χ → ∞: e_out → 0.
inline double find_delivered_restitution(double damping_factor) noexcept {
  // Below this the logarithms cancel to noise and the series is exact to rounding.
  constexpr double kSmall = 1e-7;
  if (damping_factor < kSmall) return 1.0 - 2.0 / 3.0 * damping_factor;
  const double loading = damping_factor - std::log1p(damping_factor);
  double low = 0.0;
  double high = std::min(1.0, 1.0 / damping_factor);
  // Halving the bracket 60 times reaches the last bit of a double.
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const double product = damping_factor * middle;
    const double excess = loading + product + std::log1p(-product);
    (excess > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace gudgeon
