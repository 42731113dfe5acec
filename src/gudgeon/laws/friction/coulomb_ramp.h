// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Coulomb friction, led through zero slip by straight lines.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// μ(v) = μ_k clamp((|v| − v₀)/(v₁ − v₀), 0, 1) sgn v      (Eq. F1)
///
/// v [m/s] slip speed, μ_k [1] kinetic coefficient, v₀ [m/s] slip speed up to which nothing rubs, v₁ > v₀ [m/s] slip
/// speed of full friction. |v| <= v₀: μ = 0, so a contact at rest is not held at all; |v| >= v₁: μ = ±μ_k. Continuous,
/// with corners at v₀ and v₁. Ambrósio 2003.
struct CoulombRamp {
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double dead_speed = 1e-4;                ///< v₀ [m/s]
  double full_speed = 1e-3;                ///< v₁ [m/s]

  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "coulomb_ramp";
  static constexpr std::string_view kFormula = "μ = μ_k clamp((|v| − v₀)/(v₁ − v₀), 0, 1) sgn v";
  static constexpr std::array<Parameter<CoulombRamp>, 3> kParameters{{
      {"kinetic_coefficient", "μ_k", dimension::kNone, kNotNegative, "kinetic friction coefficient",
       &CoulombRamp::kinetic_coefficient},
      {"dead_speed", "v₀", dimension::kSpeed, kNotNegative, "slip speed up to which there is no friction",
       &CoulombRamp::dead_speed},
      {"full_speed", "v₁", dimension::kSpeed, kPositive, "slip speed from which friction is full",
       &CoulombRamp::full_speed},
  }};

  [[nodiscard]] std::string_view find_conflict() const {
    return full_speed <= dead_speed ? "full_speed must be above dead_speed" : "";
  }

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double share = (std::abs(contact.slip_speed) - dead_speed) / (full_speed - dead_speed);
    return {std::copysign(kinetic_coefficient * std::clamp(share, 0.0, 1.0), contact.slip_speed)};
  }
};
static_assert(FrictionLaw<CoulombRamp>);

}  // namespace gudgeon
