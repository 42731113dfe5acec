// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dubowsky-Freudenstein: line contact of a pin in a hole whose reference length is the width.
#pragma once

#include <array>

#include "gudgeon/laws/normal/goldsmith.h"

namespace gudgeon {

/// δ = F/(π E* w) [ln(π E* w³ ΔR/(F R_i R_j)) + 1]
///
/// δ [m] penetration, F [N] force, w [m] width, E* [Pa] contact modulus, R_i and R_j [m] radii, ΔR = R_i − R_j [m].
/// With its exponent m = 3 and R_r = R_i R_j/ΔR this is Goldsmith's law; the literature has both names. F grows as far
/// as δ = w² ΔR/(R_i R_j), NaN beyond. Dubowsky & Freudenstein 1971.
struct DubowskyFreudenstein : CylindricalLaw {
  static constexpr std::string_view kName = "dubowsky_freudenstein";
  static constexpr std::string_view kFormula = "δ = F/(π E* w) [ln(π E* w³ ΔR/(F R_i R_j)) + 1]";
  static constexpr std::array<Parameter<DubowskyFreudenstein>, 0> kParameters{};
  static constexpr std::string_view kEnd = "F = π E* w³ ΔR/(R_i R_j)";

  NormalForce operator()(const NormalContact& contact) const noexcept { return eval_by_width(contact); }
  [[nodiscard]] LawEnd find_end(const NormalContact& contact) const noexcept {
    return find_logarithmic_end(contact, find_reference_by_width(contact));
  }
};
static_assert(EndingLaw<DubowskyFreudenstein>);

}  // namespace gudgeon
