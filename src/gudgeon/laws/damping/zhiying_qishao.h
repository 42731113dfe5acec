// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Zhiying-Qishao: the damping of Lankarani and Nikravesh, raised for low restitution.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 3(1 − e²)/4 · exp(2(1 − e))
///
/// χ [1] damping factor of F = F_el (1 + χ δ̇/δ̇₀), e [1] restitution asked for, 0 < e <= 1.
/// e = 1: χ = 0; e → 0: χ → 3 exp(2)/4 = 5.54. Holds for e above about 0.4: 0.896 is delivered for e = 0.9, 0.483 for
/// e = 0.5. Zhiying & Qishao 2006.
struct ZhiyingQishaoDamping {
  double restitution = 0.9;  ///< e [1]

  static constexpr std::string_view kName = "zhiying_qishao";
  static constexpr std::string_view kFormula = "χ = 3(1 − e²)/4 · exp(2(1 − e))";
  static constexpr std::array<Parameter<ZhiyingQishaoDamping>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &ZhiyingQishaoDamping::restitution},
  }};

  [[nodiscard]] double damping_factor() const {
    return 0.75 * (1.0 - restitution * restitution) * std::exp(2.0 * (1.0 - restitution));
  }
};
static_assert(DampingForm<ZhiyingQishaoDamping>);

}  // namespace gudgeon
