// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Lankarani-Nikravesh: hysteresis damping for a high restitution, the nine-bar paper's.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 3(1 − e²)/4
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 3/4. First order of the exact χ at e = 1. Holds for e near 1: 0.913 is delivered for e =
/// 0.9, 0.725 for e = 0.5. Lankarani & Nikravesh 1990; eqs. (7) and (9) of the nine-bar paper.
struct LankaraniNikraveshDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "lankarani_nikravesh";
  static constexpr std::string_view kFormula = "χ = 3(1 − e²)/4";
  static constexpr std::array<Parameter<LankaraniNikraveshDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &LankaraniNikraveshDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return 0.75 * (1.0 - restitution * restitution); }
};
static_assert(DampingForm<LankaraniNikraveshDamping>);

}  // namespace gudgeon
