// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hunt-Crossley: the first hysteresis damping, from the energy lost at high restitution.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 3(1 − e)/2
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 3/2. First order of the exact χ at e = 1. Holds for e near 1: 0.909 is delivered for e =
/// 0.9, 0.663 for e = 0.5. Hunt & Crossley 1975.
struct HuntCrossleyDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "hunt_crossley";
  static constexpr std::string_view kFormula = "χ = 3(1 − e)/2";
  static constexpr std::array<Parameter<HuntCrossleyDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &HuntCrossleyDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return 1.5 * (1.0 - restitution); }
};
static_assert(DampingForm<HuntCrossleyDamping>);

}  // namespace gudgeon
