// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The level that friction has in steady slip, as both LuGre laws take it.
#pragma once

#include <cmath>

namespace gudgeon {

/// The Stribeck curve of a law that has its parameters: g(v) = μ_k + (μ_s − μ_k) exp(−|v/v_s|^γ) [1].
/// v = 0: μ_s; |v| ≫ v_s: μ_k.
template <class Law>
double find_stribeck_level(const Law& law, double slip_speed) noexcept {
  const double ratio = std::abs(slip_speed) / law.stribeck_speed;
  const double decay = law.decay_exponent == 2.0 ? ratio * ratio : std::pow(ratio, law.decay_exponent);
  // Where exp is zero it would take its slow way to say so, and a sliding contact is there most of the time.
  constexpr double kUnderflow = 746.0;
  const double rest = decay > kUnderflow ? 0.0 : std::exp(-decay);
  return law.kinetic_coefficient + (law.static_coefficient - law.kinetic_coefficient) * rest;
}

}  // namespace gudgeon
