// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hertz: elastic contact without loss.
#pragma once

#include <array>

#include "gudgeon/laws/normal/power.h"

namespace gudgeon {

/// F = K δⁿ
///
/// δ [m] penetration, K [N/mⁿ] stiffness, n [1] exponent. δ → 0: F → 0. Returns all of the energy (restitution 1).
/// Holds for elastic, non-conforming contacts. Hertz 1881; n = 1.5 for a point contact of metals.
struct Hertz {
  double exponent = 1.5;  ///< n [1]

  static constexpr std::string_view kName = "hertz";
  static constexpr std::string_view kFormula = "F = K δⁿ";
  static constexpr std::array<Parameter<Hertz>, 1> kParameters{{
      {"exponent", "n", dimension::kNone, kExponentRange, "exponent of the penetration", &Hertz::exponent},
  }};

  [[nodiscard]] double damping_factor() const { return 0.0; }

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return elastic_power(contact.stiffness, contact.penetration, exponent);
  }
};
static_assert(NormalForceLaw<Hertz>);

}  // namespace gudgeon
