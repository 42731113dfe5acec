// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Gonthier: hysteresis damping for the whole range of restitution.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = (1 − e²)/e
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 1/e, as the exact χ. Too strong by a third near e = 1: 0.876 is delivered for e = 0.9,
/// 0.488 for e = 0.5, 0.101 for e = 0.1. Gonthier et al. 2004.
struct GonthierDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "gonthier";
  static constexpr std::string_view kFormula = "χ = (1 − e²)/e";
  static constexpr std::array<Parameter<GonthierDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &GonthierDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return (1.0 - restitution * restitution) / restitution; }
};
static_assert(DampingForm<GonthierDamping>);

}  // namespace gudgeon
