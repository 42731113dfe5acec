// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// ESDU 78035: line contact of cylinders as the data sheet has it.
#pragma once

#include <array>

#include "gudgeon/laws/normal/cylindrical.h"

namespace gudgeon {

/// δ = F/(π E* w) [ln(4π E* w ΔR/F) + 1]
///
/// δ [m] penetration, F [N] force, w [m] width, ΔR = R_i − R_j [m] clearance, E* [Pa] contact modulus.
/// Johnson's law with +1 for −1, as printed; it is softer by 2F/(π E* w).
/// F grows as far as δ = 4ΔR, NaN beyond. Holds while the arc is short. ESDU 78035, 1978.
struct Esdu78035 : CylindricalLaw {
  static constexpr std::string_view kName = "esdu_78035";
  static constexpr std::string_view kFormula = "δ = F/(π E* w) [ln(4π E* w ΔR/F) + 1]";
  static constexpr std::array<Parameter<Esdu78035>, 0> kParameters{};
  static constexpr std::string_view kEnd = "F = 4π E* w ΔR";

  /// A [N/m]
  static double find_reference(const NormalContact& contact) noexcept {
    return 4.0 * std::numbers::e * std::numbers::pi * contact.contact_modulus * find_clearance(contact);
  }
  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_clearance_and_damping(eval_logarithmic(contact, find_reference(contact)), contact);
  }
  [[nodiscard]] LawEnd find_end(const NormalContact& contact) const noexcept {
    return find_logarithmic_end(contact, find_reference(contact));
  }
};
static_assert(EndingLaw<Esdu78035>);

}  // namespace gudgeon
