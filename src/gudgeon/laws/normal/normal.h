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
  double penetration;       ///< δ [m], > 0 in contact
  double penetration_rate;  ///< δ̇ [m/s], > 0 while approaching
  double onset_speed;       ///< δ̇₀ [m/s], δ̇ at contact onset, > 0
  double stiffness;         ///< K [N/m^n], from radii and materials
};

/// Force of one contact along its normal, pressing the bodies apart.
struct NormalForce {
  double force;           ///< F [N], >= 0: elastic part plus damping, never pulling
  double elastic_force;   ///< K δ^n [N]
  double elastic_energy;  ///< stored energy U [J], dU/dδ = elastic_force
};

/// Total force of an elastic part and a damping part; a contact cannot pull, so the sum ends at zero. NaN stays NaN.
inline double never_pulling(double elastic_force, double damping_force) {
  return std::max(elastic_force + damping_force, 0.0);
}

template <class Law>
concept NormalForceLaw = LawValue<Law> && requires(const Law law, const NormalContact contact) {
  { law(contact) } noexcept -> std::same_as<NormalForce>;
  { law.exponent } -> std::convertible_to<double>;
};

}  // namespace gudgeon
