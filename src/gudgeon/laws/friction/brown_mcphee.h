// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Brown and McPhee's continuous velocity-based friction.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// μ(v) = μ_k tanh(4 x) + (μ_s − μ_k) x/(x²/4 + 3/4)² + σ₂ v,  x = v/v_t      (Eq. F6)
///
/// v [m/s] slip speed, μ_s and μ_k [1] static and kinetic coefficient, v_t [m/s] transition speed, σ₂ [s/m] viscous
/// coefficient. The second part is greatest at v_t, where it is μ_s − μ_k and the sum without viscous part is 0.07 % of
/// μ_k below μ_s. v → 0: μ → (4 μ_k + 16/9 (μ_s − μ_k)) v/v_t, so a contact at rest creeps; |v| ≫ v_t:
/// μ → ±μ_k + σ₂ v. Has derivatives of every order. Brown & McPhee 2016.
struct BrownMcPhee {
  double static_coefficient = kRequired;   ///< μ_s [1]
  double kinetic_coefficient = kRequired;  ///< μ_k [1]
  double viscous_coefficient = 0.0;        ///< σ₂ [s/m]
  double transition_speed = 1e-3;          ///< v_t [m/s]

  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "brown_mcphee";
  static constexpr std::string_view kFormula = "μ = μ_k tanh(4 v/v_t) + (μ_s − μ_k) (v/v_t)/((v/v_t)²/4 + 3/4)² + σ₂ v";
  static constexpr std::array<Parameter<BrownMcPhee>, 4> kParameters{{
      {"static_coefficient", "μ_s", dimension::kNone, kNotNegative, "static friction coefficient",
       &BrownMcPhee::static_coefficient},
      {"kinetic_coefficient", "μ_k", dimension::kNone, kNotNegative, "kinetic friction coefficient",
       &BrownMcPhee::kinetic_coefficient},
      {"viscous_coefficient", "σ₂", dimension::kTimePerLength, kNotNegative, "viscous friction coefficient",
       &BrownMcPhee::viscous_coefficient},
      {"transition_speed", "v_t", dimension::kSpeed, kPositive, "slip speed at which friction is greatest",
       &BrownMcPhee::transition_speed},
  }};

  Friction operator()(const FrictionContact& contact) const noexcept {
    const double ratio = contact.slip_speed / transition_speed;
    const double width = 0.25 * ratio * ratio + 0.75;
    return {kinetic_coefficient * std::tanh(4.0 * ratio) +
            (static_coefficient - kinetic_coefficient) * ratio / (width * width) +
            viscous_coefficient * contact.slip_speed};
  }
};
static_assert(FrictionLaw<BrownMcPhee>);

}  // namespace gudgeon
