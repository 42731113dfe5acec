// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Johnson: line contact of cylinders by elastic half-planes under Hertz's pressure.
#pragma once

#include <array>

#include "gudgeon/laws/normal/cylindrical.h"

namespace gudgeon {

/// δ = F/(π E* w) [ln(4π E* w ΔR/F) − 1]
///
/// δ [m] penetration, F [N] force, w [m] width, ΔR = R_i − R_j [m] clearance, E* [Pa] contact modulus.
/// The half axis a of the contact is Hertz's: [ln(4R_i/a) + ln(4R_j/a) − 1] in other words. F → 0: dF/dδ → 0, slowly;
/// F grows as far as δ = 4ΔR/e² = 0.541 ΔR, NaN beyond. Holds while the arc is short, a ≪ R. Johnson 1985, eq. (5.57).
struct Johnson : CylindricalLaw {
  static constexpr std::string_view kName = "johnson";
  static constexpr std::string_view kFormula = "δ = F/(π E* w) [ln(4π E* w ΔR/F) − 1]";
  static constexpr std::array<Parameter<Johnson>, 0> kParameters{};
  static constexpr std::string_view kEnd = "F = 4π E* w ΔR/e²";

  /// A [N/m]
  static double find_reference(const NormalContact& contact) noexcept {
    return 4.0 / std::numbers::e * std::numbers::pi * contact.contact_modulus * find_clearance(contact);
  }
  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_clearance_and_damping(eval_logarithmic(contact, find_reference(contact)), contact);
  }
  [[nodiscard]] LawEnd find_end(const NormalContact& contact) const noexcept {
    return find_logarithmic_end(contact, find_reference(contact));
  }
};
static_assert(EndingLaw<Johnson>);

}  // namespace gudgeon
