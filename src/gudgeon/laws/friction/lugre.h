// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// LuGre friction: bristles that bend, yield along the Stribeck curve, and damp.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"
#include "gudgeon/laws/friction/stribeck_level.h"

namespace gudgeon {

/// While the slip speed stays the same a bristle goes to its steady deflection exponentially:
/// z(t + h) = z_∞ + (z(t) − z_∞) exp(−a h).
struct BristleRelaxation {
  double rate;               ///< a = σ₀ |v|/g(v) [1/s]
  double steady_deflection;  ///< z_∞ = v/a = g(v) sgn v/σ₀ [m]
};

/// ż = v − σ₀ |v| z/g(v),      μ = σ₀ z + σ₁ ż + σ₂ v,      g(v) = μ_k + (μ_s − μ_k) exp(−|v/v_s|^γ)      (Eq. F9)
///
/// v [m/s] slip speed, z [m] bristle deflection, μ_s and μ_k [1] static and kinetic coefficient, v_s [m/s] Stribeck
/// speed, γ [1] decay exponent; per normal force: σ₀ [1/m] bristle stiffness, σ₁ [s/m] bristle damping, σ₂ [s/m]
/// viscous coefficient. z → 0: ż → v, so a contact at rest is held by a spring σ₀ and does not creep; steady slip: μ →
/// g(v) sgn v + σ₂ v, that of lugre_steady. |z| stays within max(μ_s, μ_k)/σ₀. Dissipates for certain when σ₂ >= σ₁
/// (μ_s − μ_k)/μ_k; below that, bristles let go at high speed can push. Canudas de Wit et al. 1995; the condition:
/// Barabanov & Ortega 2000.
struct Lugre {
  double static_coefficient = kRequired;   ///< μ_s [1]
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double stribeck_speed = 1e-3;            ///< v_s [m/s]
  double decay_exponent = 2.0;             ///< γ [1]
  double bristle_stiffness = 1e5;          ///< σ₀ [1/m]
  double bristle_damping = 0.0;            ///< σ₁ [s/m]
  double viscous_coefficient = 0.0;        ///< σ₂ [s/m]

  static constexpr bool kHasBristle = true;
  static constexpr std::string_view kName = "lugre";
  static constexpr std::string_view kFormula =
      "μ = σ₀ z + σ₁ ż + σ₂ v, ż = v − σ₀ |v| z/[μ_k + (μ_s − μ_k) exp(−|v/v_s|^γ)]";
  static constexpr std::array<Parameter<Lugre>, 7> kParameters{{
      {"static_coefficient", "μ_s", dimension::kNone, kPositive, "static friction coefficient",
       &Lugre::static_coefficient},
      {"kinetic_coefficient", "μ_k", dimension::kNone, kPositive, "kinetic friction coefficient",
       &Lugre::kinetic_coefficient},
      {"stribeck_speed", "v_s", dimension::kSpeed, kPositive, "slip speed over which static friction is lost",
       &Lugre::stribeck_speed},
      {"decay_exponent", "γ", dimension::kNone, kPositive, "exponent of the decay", &Lugre::decay_exponent},
      {"bristle_stiffness", "σ₀", dimension::kPerLength, kPositive, "stiffness of the bristles per normal force",
       &Lugre::bristle_stiffness},
      {"bristle_damping", "σ₁", dimension::kTimePerLength, kNotNegative, "damping of the bristles per normal force",
       &Lugre::bristle_damping},
      {"viscous_coefficient", "σ₂", dimension::kTimePerLength, kNotNegative, "viscous friction coefficient",
       &Lugre::viscous_coefficient},
  }};

  /// How fast and to what the bristle relaxes at a slip speed; at v = 0 it stays as it is (rate 0).
  [[nodiscard]] BristleRelaxation find_relaxation(double slip_speed) const noexcept {
    const double level = find_stribeck_level(*this, slip_speed);
    return {bristle_stiffness * std::abs(slip_speed) / level, std::copysign(level, slip_speed) / bristle_stiffness};
  }

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double rate = contact.slip_speed - find_relaxation(contact.slip_speed).rate * contact.bristle_deflection;
    return {bristle_stiffness * contact.bristle_deflection + bristle_damping * rate +
                viscous_coefficient * contact.slip_speed,
            rate};
  }
};
static_assert(FrictionLaw<Lugre>);

}  // namespace gudgeon
