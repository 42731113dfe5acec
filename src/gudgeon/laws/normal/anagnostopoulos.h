// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Anagnostopoulos: a linear spring and damper that return a given restitution to a given mass.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "gudgeon/laws/damping/damping.h"
#include "gudgeon/laws/normal/linear.h"

namespace gudgeon {

/// F = k δ + 2ξ√(k m) δ̇,  ξ = −ln e/√(π² + ln² e)
///
/// δ [m] penetration, δ̇ [m/s] its rate (> 0 approaching), k [N/m] stiffness, m [kg] effective mass of the two bodies,
/// 1/m = 1/m_i + 1/m_j, e [1] restitution asked for, ξ [1] damping ratio. δ → 0: F → 2ξ√(k m) δ̇₀, a step; e = 1: a
/// spring. ξ counts a whole half period, in which the force would pull at the end; never pulling, the contact delivers
/// exp(−2ξ arccos(ξ)/√(1 − ξ²)) > e: 0.902 for e = 0.9, 0.397 for e = 0.3. Holds for pounding of buildings, e near 1.
/// Anagnostopoulos 1988.
struct Anagnostopoulos {
  double stiffness = kRequired;       ///< k [N/m]
  double effective_mass = kRequired;  ///< m [kg]
  double restitution = 0.9;           ///< e [1]

  static constexpr bool kStepsAtOnset = true;
  static constexpr std::string_view kName = "anagnostopoulos";
  static constexpr std::string_view kFormula = "F = k δ + 2ξ√(k m) δ̇, ξ = −ln e/√(π² + ln² e)";
  static constexpr std::array<Parameter<Anagnostopoulos>, 3> kParameters{{
      {"stiffness", "k", kLinearStiffness, kPositive, "force over penetration", &Anagnostopoulos::stiffness},
      {"effective_mass", "m", dimension::kMass, kPositive, "mass that the two bodies meet with",
       &Anagnostopoulos::effective_mass},
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &Anagnostopoulos::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return 0.0; }

  /// ξ [1]
  [[nodiscard]] double damping_ratio() const {
    const double decrement = -std::log(restitution);
    return decrement / std::sqrt(std::numbers::pi * std::numbers::pi + decrement * decrement);
  }

  /// e_out [1] of the effective mass: the force reaches zero at the phase 2 arccos ξ, not at π.
  [[nodiscard]] double delivered_restitution() const {
    const double ratio = damping_ratio();
    return std::exp(-2.0 * ratio * std::acos(ratio) / std::sqrt(1.0 - ratio * ratio));
  }

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return eval_linear(contact, stiffness, 2.0 * damping_ratio() * std::sqrt(stiffness * effective_mass));
  }
};
static_assert(NormalForceLaw<Anagnostopoulos>);

}  // namespace gudgeon
