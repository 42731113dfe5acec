// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A Stribeck curve that is smooth everywhere.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// μ(v) = [μ_k + (μ_s − μ_k)/(1 + (v/v_s)²)] tanh(v/v_t) + σ₂ v      (Eq. F5)
///
/// v [m/s] slip speed, μ_s and μ_k [1] static and kinetic coefficient, v_s [m/s] Stribeck speed, at which half of the
/// static excess is lost, v_t [m/s] transition speed, σ₂ [s/m] viscous coefficient. v → 0: μ → μ_s v/v_t, so a contact
/// at rest creeps; v_t ≪ |v| ≪ v_s: near ±μ_s; |v| ≫ v_s: μ → ±μ_k + σ₂ v. Has derivatives of every order, unlike the
/// exponential decay of lugre_steady. Hess & Soom 1990, the sign smoothed by tanh.
struct StribeckSmooth {
  double static_coefficient = kRequired;   ///< μ_s [1]
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double stribeck_speed = 1e-2;            ///< v_s [m/s]
  double viscous_coefficient = 0.0;        ///< σ₂ [s/m]
  double transition_speed = 1e-3;          ///< v_t [m/s]

  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "stribeck_smooth";
  static constexpr std::string_view kFormula = "μ = [μ_k + (μ_s − μ_k)/(1 + (v/v_s)²)] tanh(v/v_t) + σ₂ v";
  static constexpr std::array<Parameter<StribeckSmooth>, 5> kParameters{{
      {"static_coefficient", "μ_s", dimension::kNone, kNotNegative, "static friction coefficient",
       &StribeckSmooth::static_coefficient},
      {"kinetic_coefficient", "μ_k", dimension::kNone, kNotNegative, "kinetic friction coefficient",
       &StribeckSmooth::kinetic_coefficient},
      {"stribeck_speed", "v_s", dimension::kSpeed, kPositive, "slip speed at which half of the static excess is lost",
       &StribeckSmooth::stribeck_speed},
      {"viscous_coefficient", "σ₂", dimension::kTimePerLength, kNotNegative, "viscous friction coefficient",
       &StribeckSmooth::viscous_coefficient},
      {"transition_speed", "v_t", dimension::kSpeed, kPositive, "slip speed over which friction changes its sign",
       &StribeckSmooth::transition_speed},
  }};

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double slip_speed = contact.slip_speed;
    const double ratio = slip_speed / stribeck_speed;
    const double level = kinetic_coefficient + (static_coefficient - kinetic_coefficient) / (1.0 + ratio * ratio);
    return {level * std::tanh(slip_speed / transition_speed) + viscous_coefficient * slip_speed};
  }
};
static_assert(FrictionLaw<StribeckSmooth>);

}  // namespace gudgeon
