// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// δ^n and its integral, the elastic part that the point contact laws share.
#pragma once

#include <cmath>

#include "gudgeon/laws/normal/normal.h"

namespace gudgeon {

/// F = K δ^n and U = K δ^(n+1)/(n+1) for δ > 0, zero otherwise, NaN for NaN. The Hertzian n = 1.5 needs no pow.
inline NormalForce elastic_power(double stiffness, double penetration, double exponent) noexcept {
  if (penetration <= 0.0) return {};
  const double power = exponent == 1.5 ? penetration * std::sqrt(penetration) : std::pow(penetration, exponent);
  const double force = stiffness * power;
  const double energy = force * penetration / (exponent + 1.0);
  return {force, force, energy, 0.5 * energy};  // K grows with √R_r
}

inline constexpr ParameterRange kExponentRange{1.0, 3.0, false, false};

}  // namespace gudgeon
