// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hu-Guo: hysteresis damping that is right to second order at high restitution.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 3(1 − e)/(2e)
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 3/(2e), above the exact 1/e. 0.8999 is delivered for e = 0.9, 0.488 for e = 0.5. Sources
/// with half of this factor deliver another restitution and are not followed. Hu & Guo 2015.
struct HuGuoDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "hu_guo";
  static constexpr std::string_view kFormula = "χ = 3(1 − e)/(2e)";
  static constexpr std::array<Parameter<HuGuoDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &HuGuoDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return 1.5 * (1.0 - restitution) / restitution; }
};
static_assert(DampingForm<HuGuoDamping>);

}  // namespace gudgeon
