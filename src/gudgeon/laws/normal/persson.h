// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Persson: a journal in a conforming bearing, the exact solution of plane elasticity.
#pragma once

#include <array>

#include "gudgeon/laws/normal/cylindrical.h"

namespace gudgeon {

/// b² at which Persson's force becomes infinite, the root of 2 − ln(1 + b²) − 2b⁴.
inline constexpr double kPerssonLimit = 0.8346152454776573;

/// ∫ x (1 + x)/[(2 − ln(1 + x) − 2x²)(1 − x)²] dx from 0 to b² by 16 Gauss points: to 1e-14, to 2e-11 towards the
/// limit.
inline double integrate_persson(double square) noexcept {
  constexpr std::array<std::array<double, 2>, 8> kGauss{{{0.9894009349916499, 0.027152459411754095},
                                                         {0.9445750230732326, 0.062253523938647892},
                                                         {0.8656312023878318, 0.095158511682492784},
                                                         {0.7554044083550030, 0.124628971255533872},
                                                         {0.6178762444026438, 0.149595988816576732},
                                                         {0.4580167776572274, 0.169156519395002538},
                                                         {0.2816035507792589, 0.182603415044923589},
                                                         {0.0950125098376374, 0.189450610455068496}}};
  // Towards the limit the integrand is residue/(limit − x) beside a smooth rest; far from it that would only cancel.
  constexpr double kFar = 0.3;
  constexpr double kSlope = 1.0 / (1.0 + kPerssonLimit) + 4.0 * kPerssonLimit;
  constexpr double kResidue =
      kPerssonLimit * (1.0 + kPerssonLimit) / (kSlope * (1.0 - kPerssonLimit) * (1.0 - kPerssonLimit));
  const double residue = square > kFar ? kResidue : 0.0;
  double sum = 0.0;
  for (const auto& [place, weight] : kGauss) {
    for (const double side : {-place, place}) {
      const double x = 0.5 * square * (1.0 + side);
      const double rest = (2.0 - std::log1p(x) - 2.0 * x * x) * (1.0 - x) * (1.0 - x);
      sum += weight * (x * (1.0 + x) / rest - residue / (kPerssonLimit - x));
    }
  }
  return 0.5 * square * sum - residue * std::log1p(-square / kPerssonLimit);
}

/// Persson's elastic force and energy, dδ = 2ΔR db²/(1 − b²)².
inline NormalForce eval_persson(const NormalContact& contact) noexcept {
  if (contact.penetration <= 0.0) return {};
  const double clearance = find_clearance(contact);
  const double square = contact.penetration / (2.0 * clearance + contact.penetration);
  if (!(square < kPerssonLimit)) return kNoForceKnown;
  const double line = 2.0 * std::numbers::pi * contact.contact_modulus * contact.width * clearance;
  const double force = line * square * (1.0 + square) / (2.0 - std::log1p(square) - 2.0 * square * square);
  return {force, force, 2.0 * line * clearance * integrate_persson(square)};
}

/// F = 2π E* w ΔR (b² + 1) b²/(2 − ln(b² + 1) − 2b⁴), b = tan(ε/2), cos ε = ΔR/(ΔR + δ)
///
/// δ [m] penetration, F [N] force, w [m] width, ΔR = R_i − R_j [m] clearance, E* [Pa] contact modulus,
/// ε [1] half of the contact's arc, told from δ by where the circles would overlap, so that b² = δ/(2ΔR + δ).
/// δ → 0: F → π/2 E* w δ, Hertz's line contact. The 2 before π E* is the modulus E/(1 − ν²) of one body, which Persson
/// writes; with the contact modulus E* in its place, as some have it, the force is half of that. δ → 10.093 ΔR,
/// ε → 84.83°: F → ∞, NaN beyond. Holds for like materials without friction; others by their E*. Persson 1964.
struct Persson : CylindricalLaw {
  static constexpr std::string_view kName = "persson";
  static constexpr std::string_view kFormula =
      "F = 2π E* w ΔR (b² + 1) b²/(2 − ln(b² + 1) − 2b⁴), b = tan(ε/2), cos ε = ΔR/(ΔR + δ)";
  static constexpr std::array<Parameter<Persson>, 0> kParameters{};
  static constexpr std::string_view kEnd = "δ = 10.093 ΔR, where F → ∞";

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_clearance_and_damping(eval_persson(contact), contact);
  }
  [[nodiscard]] LawEnd find_end(const NormalContact& contact) const noexcept {
    return {2.0 * find_clearance(contact) * kPerssonLimit / (1.0 - kPerssonLimit),
            std::numeric_limits<double>::infinity()};
  }
};
static_assert(EndingLaw<Persson>);

}  // namespace gudgeon
