// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Flores et al.: hysteresis damping for hard and soft bodies.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 8(1 − e)/(5e)
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 8/(5e), above the exact 1/e. Slightly too strong everywhere: 0.894 is delivered for e =
/// 0.9, 0.470 for e = 0.5. Flores, Machado, Silva & Martins 2011.
struct FloresDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "flores";
  static constexpr std::string_view kFormula = "χ = 8(1 − e)/(5e)";
  static constexpr std::array<Parameter<FloresDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &FloresDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return 1.6 * (1.0 - restitution) / restitution; }
};
static_assert(DampingForm<FloresDamping>);

}  // namespace gudgeon
