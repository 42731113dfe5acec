// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Goldsmith: line contact of cylinders whose reference length is the width.
#pragma once

#include <array>

#include "gudgeon/laws/normal/cylindrical.h"

namespace gudgeon {

/// A [N/m] of a law whose length is the width: e π E* w²/R_r.
inline double find_reference_by_width(const NormalContact& contact) noexcept {
  const double radius = contact.bearing_radius * contact.journal_radius / find_clearance(contact);
  return std::numbers::e * std::numbers::pi * contact.contact_modulus * contact.width * contact.width / radius;
}

/// The law that Goldsmith's shares with Dubowsky and Freudenstein's, complete with damping.
inline NormalForce eval_by_width(const NormalContact& contact) noexcept {
  NormalForce elastic = eval_logarithmic(contact, find_reference_by_width(contact));
  elastic.energy_by_radius = -energy_by_length(elastic, contact);
  return with_damping(elastic, contact);
}

/// δ = F/(π E* w) [ln(π E* w³/(F R_r)) + 1]
///
/// δ [m] penetration, F [N] force, w [m] width, E* [Pa] contact modulus, R_r [m] relative radius, 1/R_r = 1/R_j −
/// 1/R_i. The width stands for the depth at which the penetration is told. Its exponent is printed as 1 and as 3; only
/// 3 keeps the dimensions. F grows as far as δ = w²/R_r, NaN beyond. Holds while w ≪ R_r. Goldsmith 1960.
struct Goldsmith : CylindricalLaw {
  static constexpr std::string_view kName = "goldsmith";
  static constexpr std::string_view kFormula = "δ = F/(π E* w) [ln(π E* w³/(F R_r)) + 1]";
  static constexpr std::array<Parameter<Goldsmith>, 0> kParameters{};
  static constexpr std::string_view kEnd = "F = π E* w³/R_r";

  NormalForce operator()(const NormalContact& contact) const noexcept { return eval_by_width(contact); }
  [[nodiscard]] LawEnd find_end(const NormalContact& contact) const noexcept {
    return find_logarithmic_end(contact, find_reference_by_width(contact));
  }
};
static_assert(EndingLaw<Goldsmith>);

}  // namespace gudgeon
