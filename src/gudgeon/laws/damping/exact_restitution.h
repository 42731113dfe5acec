// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The damping that delivers the restitution it is asked for.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"
#include "gudgeon/laws/damping/delivered_restitution.h"

namespace gudgeon {

/// χ (1 + e) = ln[(1 + χ)/(1 − χ e)]
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// Solved for χ, which lies between 3(1 − e)/(2(1 − e + e²)) and the smaller of 1/e and 3(1 − e)/(2e). e → 1:
/// χ → 3(1 − e)/2; e → 0: χ → 1/e. Holds for all of (0, 1], whatever stiffness, mass, exponent and onset speed, by the
/// energy balance of an impact: m v dv = −F_el (1 + χ v/v₀) dδ in and out again.
struct ExactRestitutionDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "exact_restitution";
  static constexpr std::string_view kFormula = "χ (1 + e) = ln[(1 + χ)/(1 − χ e)]";
  static constexpr std::array<Parameter<ExactRestitutionDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &ExactRestitutionDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return find_exact_damping_factor(restitution); }
};
static_assert(DampingForm<ExactRestitutionDamping>);

}  // namespace gudgeon
