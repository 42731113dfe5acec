// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Herbert-McWhannell: hysteresis damping from an approximate balance over the whole impact.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 6(1 − e)/((2e − 1)² + 3)
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 3/2. Holds for e above about 0.8: 0.901 is delivered for e = 0.9, 0.594 for e = 0.5.
/// Herbert & McWhannell 1977.
struct HerbertMcwhannellDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "herbert_mcwhannell";
  static constexpr std::string_view kFormula = "χ = 6(1 − e)/((2e − 1)² + 3)";
  static constexpr std::array<Parameter<HerbertMcwhannellDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &HerbertMcwhannellDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const {
    const double square = (2.0 * restitution - 1.0) * (2.0 * restitution - 1.0);
    return 6.0 * (1.0 - restitution) / (square + 3.0);
  }
};
static_assert(DampingForm<HerbertMcwhannellDamping>);

}  // namespace gudgeon
