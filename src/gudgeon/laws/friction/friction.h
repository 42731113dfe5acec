// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The family of friction laws: the friction force is μ(v) times the normal force, against the slip.
#pragma once

#include <concepts>

#include "gudgeon/laws/law.h"

namespace gudgeon {

/// State of one contact along its slip.
struct FrictionContact {
  double slip_speed;                ///< v [m/s] of the journal's surface relative to the bearing's
  double bristle_deflection = 0.0;  ///< z [m], zero at contact onset
};

struct Friction {
  double coefficient;         ///< μ [1]; the force on the journal is −μ F along the slip direction
  double bristle_rate = 0.0;  ///< ż [m/s]
};

/// A friction law maps slip speed v and, when it has a bristle, its deflection z to the signed coefficient μ and to ż.
/// Odd: μ(−v, −z) = −μ(v, z). Without a bristle μ has v's sign.
/// With one, z starts at zero and ż(−v, −z) = −ż(v, z); the energy that bristles hold is σ₀ z²/2 per normal force.
template <class Law>
concept FrictionLaw = LawValue<Law> && requires(const Law law, const FrictionContact contact) {
  { law(contact) }
  noexcept->std::same_as<Friction>;
  { Law::kHasBristle } -> std::convertible_to<bool>;
};

}  // namespace gudgeon
