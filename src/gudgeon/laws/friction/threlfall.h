// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Coulomb friction that grows exponentially out of zero slip.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// μ(v) = μ_k (1 − exp(−3 |v|/v_t)) sgn v      (Eq. F3)
///
/// v [m/s] slip speed, μ_k [1] kinetic coefficient, v_t [m/s] transition speed. v → 0: μ → 3 μ_k v/v_t, so a contact at
/// rest creeps; |v| = v_t: 95 % of μ_k; |v| ≫ v_t: μ → ±μ_k. Its slope is continuous through zero, its curvature is
/// not. Threlfall 1978; where others hold 0.95 μ_k beyond v_t, the exponential goes on here, so that μ_k is reached.
struct Threlfall {
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double transition_speed = 1e-3;          ///< v_t [m/s]

  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "threlfall";
  static constexpr std::string_view kFormula = "μ = μ_k (1 − exp(−3 |v|/v_t)) sgn v";
  static constexpr std::array<Parameter<Threlfall>, 2> kParameters{{
      {"kinetic_coefficient", "μ_k", dimension::kNone, kNotNegative, "kinetic friction coefficient",
       &Threlfall::kinetic_coefficient},
      {"transition_speed", "v_t", dimension::kSpeed, kPositive, "slip speed at which friction is 95 % of its limit",
       &Threlfall::transition_speed},
  }};

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double growth = -std::expm1(-3.0 * std::abs(contact.slip_speed) / transition_speed);
    return {std::copysign(kinetic_coefficient * growth, contact.slip_speed)};
  }
};
static_assert(FrictionLaw<Threlfall>);

}  // namespace gudgeon
