// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Liu et al.: Hertz's pressure over the arc on which a journal and its bearing would overlap.
#pragma once

#include <array>

#include "gudgeon/laws/normal/cylindrical.h"

namespace gudgeon {

/// ∫ t^(3/2) (1 + t)^(-1/2) dt from 0 to x >= 0.
inline double integrate_liu(double x) noexcept {
  const double root = std::sqrt(x);
  // In closed form the terms cancel to x²; from here on that costs three digits of the 16.
  constexpr double kSmall = 0.05;
  if (!(x < kSmall)) return 0.25 * root * std::sqrt(1.0 + x) * (2.0 * x - 3.0) + 0.75 * std::asinh(root);
  double sum = 0.0;
  double term = 1.0;
  // 0.05^13 is below rounding.
  for (int k = 0; k < 13; ++k) {
    sum += term / (k + 2.5);
    term *= -x * (k + 0.5) / (k + 1.0);
  }
  return sum * x * x * root;
}

/// Liu's elastic force and energy.
inline NormalForce eval_liu(const NormalContact& contact) noexcept {
  if (contact.penetration <= 0.0) return {};
  const double clearance = find_clearance(contact);
  const double ratio = contact.penetration / clearance;
  const double line = 0.5 * std::numbers::pi * contact.contact_modulus * contact.width;
  const double force = line * contact.penetration * std::sqrt(0.5 * ratio / (1.0 + ratio));
  const double energy = line * std::numbers::sqrt2 / 2.0 * clearance * clearance * integrate_liu(ratio);
  return {force, force, energy};
}

/// F = π/2 · E* w δ √(δ/(2(ΔR + δ)))
///
/// δ [m] penetration, F [N] force, w [m] width, ΔR = R_i − R_j [m] clearance, E* [Pa] contact modulus.
/// The elliptic pressure reaches from −ε to ε, cos ε = ΔR/(ΔR + δ), and its peak is E* δ/(2R); the root is sin(ε/2).
/// δ → 0: F → π/2 E* w δ ε/2, so it is softer than Hertz's line contact, π/2 E* w δ, by sin(ε/2) on a short arc.
/// Meant for small clearances and long arcs. Liu, Zhang & Yang 2007.
struct Liu : CylindricalLaw {
  static constexpr std::string_view kName = "liu";
  static constexpr std::string_view kFormula = "F = π/2 · E* w δ √(δ/(2(ΔR + δ)))";
  static constexpr std::array<Parameter<Liu>, 0> kParameters{};

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_clearance_and_damping(eval_liu(contact), contact);
  }
};
static_assert(NormalForceLaw<Liu>);

}  // namespace gudgeon
