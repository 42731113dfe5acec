// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The energy balance of a damped impact: which restitution a damping factor delivers, and which factor delivers one.
#pragma once

#include <algorithm>
#include <cmath>

namespace gudgeon {

/// x − ln(1 + x) for x > −1, accurate to rounding also where the two cancel; x²/2 for small x.
inline double log_remainder(double x) noexcept {
  // From here on subtracting costs less than two digits of the 16.
  constexpr double kSmall = 0.25;
  if (!(std::abs(x) < kSmall)) return x - std::log1p(x);
  double sum = 0.0;
  double power = -x;
  // 0.25^27 is below rounding.
  for (int k = 2; k < 30; ++k) {
    power *= -x;
    sum += power / k;
  }
  return sum;
}

/// Energy that an impact with that restitution would have to spare, as a multiple of a positive number:
/// [χ − ln(1 + χ)] − [−χ e − ln(1 − χ e)], zero where the restitution is the one that χ delivers, falling with χ and e.
inline double find_energy_excess(double damping_factor, double restitution) noexcept {
  return log_remainder(damping_factor) - log_remainder(-damping_factor * restitution);
}

/// e_out, the root in (0, 1] of χ (1 + e_out) = ln[(1 + χ)/(1 − χ e_out)]
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), >= 0. Holds for every elastic force, mass and onset speed.
/// χ → 0: e_out → 1 − 2χ/3; χ → ∞: e_out → 0.
inline double find_delivered_restitution(double damping_factor) noexcept {
  if (damping_factor == 0.0) return 1.0;
  double low = 0.0;
  double high = std::min(1.0, 1.0 / damping_factor);
  // Halving the bracket 60 times reaches the last bit of a double.
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (find_energy_excess(damping_factor, middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// χ, the root of χ (1 + e) = ln[(1 + χ)/(1 − χ e)] for 0 < e <= 1. e = 1: 0; e → 0: 1/e.
inline double find_exact_damping_factor(double restitution) noexcept {
  const double loss = 1.5 * (1.0 - restitution);
  // Known forms enclose the root; near e = 1 they agree to first order, so that halving reaches its last bit.
  double low = loss / (1.0 - restitution + restitution * restitution);
  double high = std::min(1.0, loss) / restitution;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (find_energy_excess(middle, restitution) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace gudgeon
