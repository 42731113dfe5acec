// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Radzimovsky: line contact of cylinders by elastic half-planes under a parabolic pressure.
#pragma once

#include <array>

#include "gudgeon/laws/normal/cylindrical.h"

namespace gudgeon {

/// δ = F/(π E* w) [2/3 + ln(4R_i/b) + ln(4R_j/b)], b = 4√(F R_r/(π E* w))
///
/// δ [m] penetration, F [N] force, w [m] width, R_i and R_j [m] radii, 1/R_r = 1/R_j − 1/R_i, E* [Pa] contact modulus,
/// b [m] the full width of Hertz's contact. The 2/3 belongs to the full width: a parabolic pressure lifts Johnson's
/// constant, −1 beside ln(4R/a), by 5/3 − 2 ln 2, which is 2/3 beside ln(4R/2a). Taken with the half width, as some
/// have it, no pressure gives this penetration. F grows as far as δ = 0.717 ΔR, NaN beyond. Holds while the arc is
/// short. Radzimovsky 1953; b as in Roark's formulas.
struct Radzimovsky : CylindricalLaw {
  static constexpr std::string_view kName = "radzimovsky";
  static constexpr std::string_view kFormula = "δ = F/(π E* w) [2/3 + ln(4R_i/b) + ln(4R_j/b)], b = 4√(F R_r/(π E* w))";
  static constexpr std::array<Parameter<Radzimovsky>, 0> kParameters{};
  static constexpr std::string_view kEnd = "F = π E* w ΔR e^(−1/3)";

  /// A [N/m]: 16 R_i R_j/b² = π E* w ΔR/F
  static double find_reference(const NormalContact& contact) noexcept {
    return std::exp(2.0 / 3.0) * std::numbers::pi * contact.contact_modulus * find_clearance(contact);
  }
  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_clearance_and_damping(eval_logarithmic(contact, find_reference(contact)), contact);
  }
  [[nodiscard]] LawEnd find_end(const NormalContact& contact) const noexcept {
    return find_logarithmic_end(contact, find_reference(contact));
  }
};
static_assert(EndingLaw<Radzimovsky>);

}  // namespace gudgeon
