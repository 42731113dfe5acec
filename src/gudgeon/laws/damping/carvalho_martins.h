// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Carvalho-Martins: a rational approximation of the exact damping.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 3/2 · (1 − e)(11 − e)/(1 + 9e)
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 33/2. Holds for e above about 0.2: delivers e within 2e-4 from e = 0.5 upward, 0.304 for
/// e = 0.3. Carvalho & Martins 2019.
struct CarvalhoMartinsDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "carvalho_martins";
  static constexpr std::string_view kFormula = "χ = 3/2 · (1 − e)(11 − e)/(1 + 9e)";
  static constexpr std::array<Parameter<CarvalhoMartinsDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &CarvalhoMartinsDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const {
    return 1.5 * (1.0 - restitution) * (11.0 - restitution) / (1.0 + 9.0 * restitution);
  }
};
static_assert(DampingForm<CarvalhoMartinsDamping>);

}  // namespace gudgeon
