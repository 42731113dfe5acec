// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Lee-Wang: hysteresis damping that is half of Hunt and Crossley's.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 3(1 − e)/4
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 3/4. Too weak by half even at e = 1: 0.952 is delivered for e = 0.9, 0.799 for e = 0.5.
/// Lee & Wang 1983.
struct LeeWangDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "lee_wang";
  static constexpr std::string_view kFormula = "χ = 3(1 − e)/4";
  static constexpr std::array<Parameter<LeeWangDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &LeeWangDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return 0.75 * (1.0 - restitution); }
};
static_assert(DampingForm<LeeWangDamping>);

}  // namespace gudgeon
