// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The family of normal contact force laws: what a law is given and what it returns.
#pragma once

#include <algorithm>
#include <concepts>

#include "gudgeon/laws/law.h"

namespace gudgeon {

/// State of one contact in its normal direction.
struct NormalContact {
  double penetration;            ///< δ [m], > 0 in contact
  double penetration_rate;       ///< δ̇ [m/s], > 0 while approaching
  double onset_speed;            ///< δ̇₀ [m/s], δ̇ at contact onset, > 0
  double stiffness;              ///< K [N/m^n], from radii and materials
  double damping_factor = 0.0;   ///< χ [1], the law's own damping_factor(), found once
  double bearing_radius = 0.0;   ///< R_i [m]; infinite where the bearing is flat
  double journal_radius = 0.0;   ///< R_j [m]
  double width = 0.0;            ///< w [m] along the axis
  double contact_modulus = 0.0;  ///< E* [Pa], 1/E* = (1 − ν_i²)/E_i + (1 − ν_j²)/E_j
};

/// Force of one contact along its normal, pressing the bodies apart.
struct NormalForce {
  double force = 0.0;             ///< F [N], >= 0: elastic part plus damping, never pulling
  double elastic_force = 0.0;     ///< F_el [N], without damping
  double elastic_energy = 0.0;    ///< stored energy U [J], ∂U/∂δ = elastic_force
  double energy_by_radius = 0.0;  ///< ∂U/∂ln R_r [J] at constant δ, where the law depends on the relative radius
  double energy_by_clearance = 0.0;  ///< ∂U/∂ln ΔR [J] at constant δ, where the law depends on ΔR = R_i − R_j
};

/// The last point of a law that is defined only so far.
struct LawEnd {
  double penetration = 0.0;  ///< [m]
  double force = 0.0;        ///< F_el [N] there; may be infinite
};

/// Total force of an elastic part and a damping part; a contact cannot pull, so the sum ends at zero. NaN stays NaN.
inline double never_pulling(double elastic_force, double damping_force) {
  return std::max(elastic_force + damping_force, 0.0);
}

/// F = F_el (1 + χ δ̇/δ̇₀), never pulling: an elastic force with the damping shared by most laws.
inline NormalForce with_damping(NormalForce elastic, const NormalContact& contact) noexcept {
  const double damping =
      elastic.elastic_force * contact.damping_factor * contact.penetration_rate / contact.onset_speed;
  elastic.force = never_pulling(elastic.elastic_force, damping);
  return elastic;
}

/// A law of normal force. Its damping_factor() is χ of the shape F = F_el (1 + χ δ̇/δ̇₀), 0 for a law without damping or
/// with damping of another shape; it may be costly and is found once, before a run.
template <class Law>
concept NormalForceLaw = LawValue<Law> && requires(const Law law, const NormalContact contact) {
  { law(contact) }
  noexcept->std::same_as<NormalForce>;
  { law.damping_factor() } -> std::same_as<double>;
};

/// A law that says where it ends: kEnd in its own symbols, find_end() in numbers, for the radii, width and modulus
/// given. Beyond it has no force, and a motion cannot go on.
template <class Law>
concept EndingLaw = NormalForceLaw<Law> && requires(const Law law, const NormalContact contact) {
  { Law::kEnd } -> std::convertible_to<std::string_view>;
  { law.find_end(contact) }
  noexcept->std::same_as<LawEnd>;
};

}  // namespace gudgeon
