// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Lankarani-Nikravesh: Hertzian contact with hysteresis damping for a high restitution.
#pragma once

#include <array>

#include "gudgeon/laws/normal/power.h"

namespace gudgeon {

/// F = K δⁿ (1 + χ δ̇/δ̇₀),  χ = 3 (1 − e²)/4
///
/// δ [m] penetration, δ̇ [m/s] its rate (> 0 approaching), δ̇₀ [m/s] the rate at onset, K [N/mⁿ] stiffness,
/// n [1] exponent, e [1] restitution asked for. δ → 0: F → 0; e = 1: Hertz. Never pulls: the sum ends at zero.
/// Holds for e near 1: the restitution delivered is 0.913 for e = 0.9 and 0.725 for e = 0.5.
/// Lankarani & Nikravesh 1990; eqs. (7) and (9) of the nine-bar paper.
struct LankaraniNikravesh {
  double restitution = 0.9;  ///< e [1]
  double exponent = 1.5;     ///< n [1]

  static constexpr std::string_view kName = "lankarani_nikravesh";
  static constexpr std::string_view kFormula = "F = K δⁿ (1 + 3(1 − e²)/4 · δ̇/δ̇₀)";
  static constexpr std::array<Parameter<LankaraniNikravesh>, 2> kParameters{{
      {"restitution",
       "e",
       dimension::kNone,
       {0.0, 1.0, true, false},
       "coefficient of restitution asked for",
       &LankaraniNikravesh::restitution},
      {"exponent", "n", dimension::kNone, kExponentRange, "exponent of the penetration", &LankaraniNikravesh::exponent},
  }};

  [[nodiscard]] double damping_factor() const { return 0.75 * (1.0 - restitution * restitution); }

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_damping(elastic_power(contact.stiffness, contact.penetration, exponent), contact);
  }
};
static_assert(NormalForceLaw<LankaraniNikravesh>);

}  // namespace gudgeon
