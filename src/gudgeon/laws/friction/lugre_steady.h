// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// LuGre friction with its bristle at the steady deflection: the Stribeck curve that the nine-bar paper uses.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"
#include "gudgeon/laws/friction/stribeck_level.h"

namespace gudgeon {

/// μ(v) = [μ_k + (μ_s − μ_k) exp(−|v/v_s|^γ)] tanh(v/v_t) + σ₂ v      (Eq. F7)
///
/// v [m/s] slip speed, μ_s and μ_k [1] static and kinetic coefficient, v_s [m/s] Stribeck speed, γ [1] decay exponent,
/// σ₂ [s/m] viscous coefficient, v_t [m/s] transition speed. In the steady state σ₀ and σ₁ drop out; the sign of v is
/// smoothed by tanh, so that v → 0: μ → μ_s v/v_t. |v| ≫ v_s: μ → ±μ_k + σ₂ v.
/// Canudas de Wit et al. 1995; eqs. (11) to (14) of the nine-bar paper.
struct LugreSteady {
  double static_coefficient = kRequired;   ///< μ_s [1]
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double stribeck_speed = 1e-3;            ///< v_s [m/s]
  double decay_exponent = 2.0;             ///< γ [1]
  double viscous_coefficient = 0.0;        ///< σ₂ [s/m]
  double transition_speed = 1e-4;          ///< v_t [m/s]

  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "lugre_steady";
  static constexpr std::string_view kFormula = "μ = [μ_k + (μ_s − μ_k) exp(−|v/v_s|^γ)] tanh(v/v_t) + σ₂ v";
  static constexpr std::array<Parameter<LugreSteady>, 6> kParameters{{
      {"static_coefficient", "μ_s", dimension::kNone, kNotNegative, "static friction coefficient",
       &LugreSteady::static_coefficient},
      {"kinetic_coefficient", "μ_k", dimension::kNone, kNotNegative, "kinetic friction coefficient",
       &LugreSteady::kinetic_coefficient},
      {"stribeck_speed", "v_s", dimension::kSpeed, kPositive, "slip speed over which static friction is lost",
       &LugreSteady::stribeck_speed},
      {"decay_exponent", "γ", dimension::kNone, kPositive, "exponent of the decay", &LugreSteady::decay_exponent},
      {"viscous_coefficient", "σ₂", dimension::kTimePerLength, kNotNegative, "viscous friction coefficient",
       &LugreSteady::viscous_coefficient},
      {"transition_speed", "v_t", dimension::kSpeed, kPositive, "slip speed over which friction changes its sign",
       &LugreSteady::transition_speed},
  }};

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double slip_speed = contact.slip_speed;
    const double level = find_stribeck_level(*this, slip_speed);
    return {level * std::tanh(slip_speed / transition_speed) + viscous_coefficient * slip_speed};
  }
};
static_assert(FrictionLaw<LugreSteady>);

}  // namespace gudgeon
