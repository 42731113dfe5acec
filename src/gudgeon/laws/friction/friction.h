// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The family of friction laws: the friction force is μ(v) times the normal force, against the slip.
#pragma once

#include <concepts>

#include "gudgeon/laws/law.h"

namespace gudgeon {

/// A friction law maps the slip speed v [m/s] of the journal surface relative to the bearing surface to the signed
/// coefficient μ(v) [1]: odd in v, of v's sign. The force on the journal is −μ F along the slip direction.
template <class Law>
concept FrictionLaw = LawValue<Law> && requires(const Law law, double slip_speed) {
  { law(slip_speed) } noexcept -> std::same_as<double>;
};

}  // namespace gudgeon
