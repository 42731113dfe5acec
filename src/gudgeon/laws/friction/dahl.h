// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dahl friction: a bristle that bends like a spring and yields at the kinetic friction.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// ż = v |w|^i sgn w,  w = 1 − (σ₀ z/μ_k) sgn v,      μ = σ₀ z      (Eq. F8)
///
/// v [m/s] slip speed, z [m] bristle deflection, μ_k [1] kinetic coefficient, σ₀ [1/m] bristle stiffness per normal
/// force, i [1] shape exponent: 1 for most materials, above for ductile, below for brittle ones. μ depends on the path
/// of slip, not on its speed. z → 0: ż → v, so a contact at rest is held by a spring σ₀ and does not creep; steady
/// slip: μ → ±μ_k, for i = 1 as 1 − exp(−σ₀ |s|/μ_k) over the slip s. |z| stays within μ_k/σ₀ and always dissipates.
/// Dahl 1968.
struct Dahl {
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double bristle_stiffness = 1e5;          ///< σ₀ [1/m]
  double shape_exponent = 1.0;             ///< i [1]

  static constexpr bool kHasBristle = true;
  static constexpr std::string_view kName = "dahl";
  static constexpr std::string_view kFormula = "μ = σ₀ z, ż = v |w|^i sgn w, w = 1 − (σ₀ z/μ_k) sgn v";
  static constexpr std::array<Parameter<Dahl>, 3> kParameters{{
      {"kinetic_coefficient", "μ_k", dimension::kNone, kPositive, "kinetic friction coefficient",
       &Dahl::kinetic_coefficient},
      {"bristle_stiffness", "σ₀", dimension::kPerLength, kPositive, "stiffness of the bristles per normal force",
       &Dahl::bristle_stiffness},
      {"shape_exponent", "i", dimension::kNone, kPositive, "exponent of the yield", &Dahl::shape_exponent},
  }};

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double coefficient = bristle_stiffness * contact.bristle_deflection;
    const double reserve = 1.0 - std::copysign(1.0, contact.slip_speed) * coefficient / kinetic_coefficient;
    const double yield =
        shape_exponent == 1.0 ? reserve : std::copysign(std::pow(std::abs(reserve), shape_exponent), reserve);
    return {coefficient, contact.slip_speed * yield};
  }
};
static_assert(FrictionLaw<Dahl>);

}  // namespace gudgeon
