// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Friction that rises on a parabola to its static value and decays exponentially to its kinetic one.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// |v| <= v_t:  μ(v) = μ_s [1 − (1 − |v|/v_t)²] sgn v      (Eq. F4)
/// |v| >  v_t:  μ(v) = [μ_k + (μ_s − μ_k) exp(−ξ (|v| − v_t))] sgn v
///
/// v [m/s] slip speed, μ_s and μ_k [1] static and kinetic coefficient, v_t [m/s] slip speed of the peak, ξ [s/m] decay
/// rate. v → 0: μ → 2 μ_s v/v_t, so a contact at rest creeps; |v| = v_t: exactly ±μ_s; |v| ≫ v_t: μ → ±μ_k. Continuous,
/// with a corner at v_t. Bengisu & Akay 1994.
struct BengisuAkay {
  double static_coefficient = kRequired;   ///< μ_s [1]
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double transition_speed = 1e-3;          ///< v_t [m/s]
  double decay_rate = 1e3;                 ///< ξ [s/m]

  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "bengisu_akay";
  static constexpr std::string_view kFormula =
      "μ = μ_s [1 − (1 − |v|/v_t)²] sgn v up to v_t, [μ_k + (μ_s − μ_k) exp(−ξ (|v| − v_t))] sgn v beyond";
  static constexpr std::array<Parameter<BengisuAkay>, 4> kParameters{{
      {"static_coefficient", "μ_s", dimension::kNone, kNotNegative, "static friction coefficient",
       &BengisuAkay::static_coefficient},
      {"kinetic_coefficient", "μ_k", dimension::kNone, kNotNegative, "kinetic friction coefficient",
       &BengisuAkay::kinetic_coefficient},
      {"transition_speed", "v_t", dimension::kSpeed, kPositive, "slip speed at which friction is greatest",
       &BengisuAkay::transition_speed},
      {"decay_rate", "ξ", dimension::kTimePerLength, kNotNegative, "rate at which static friction is lost beyond it",
       &BengisuAkay::decay_rate},
  }};

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double speed = std::abs(contact.slip_speed);
    if (speed <= transition_speed) {
      const double share = speed / transition_speed;
      return {std::copysign(static_coefficient * share * (2.0 - share), contact.slip_speed)};
    }
    const double excess =
        (static_coefficient - kinetic_coefficient) * std::exp(-decay_rate * (speed - transition_speed));
    return {std::copysign(kinetic_coefficient + excess, contact.slip_speed)};
  }
};
static_assert(FrictionLaw<BengisuAkay>);

}  // namespace gudgeon
