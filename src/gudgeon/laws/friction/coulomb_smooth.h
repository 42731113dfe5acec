// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Coulomb friction, smoothed through zero slip.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// μ(v) = μ_k tanh(v/v_t)      (Eq. F2)
///
/// v [m/s] slip speed, μ_k [1] kinetic coefficient, v_t [m/s] transition speed. v → 0: μ → μ_k v/v_t, so a contact at
/// rest creeps; |v| ≫ v_t: μ → ±μ_k. Rooney & Deravi 1982 in its tanh form.
struct CoulombSmooth {
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double transition_speed = 1e-3;          ///< v_t [m/s]

  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "coulomb_smooth";
  static constexpr std::string_view kFormula = "μ = μ_k tanh(v/v_t)";
  static constexpr std::array<Parameter<CoulombSmooth>, 2> kParameters{{
      {"kinetic_coefficient", "μ_k", dimension::kNone, kNotNegative, "kinetic friction coefficient",
       &CoulombSmooth::kinetic_coefficient},
      {"transition_speed", "v_t", dimension::kSpeed, kPositive, "slip speed over which friction changes its sign",
       &CoulombSmooth::transition_speed},
  }};

  Friction operator()(const FrictionContact& contact) const noexcept {
    return {kinetic_coefficient * std::tanh(contact.slip_speed / transition_speed)};
  }
};
static_assert(FrictionLaw<CoulombSmooth>);

}  // namespace gudgeon
