// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear in proportion to the work of friction.
#pragma once

#include <array>

#include "gudgeon/laws/wear/wear.h"

namespace gudgeon {

/// ḣ = k_e |μ| p |v|
///
/// |μ| [1] friction coefficient at work, p [Pa] contact pressure, |v| [m/s] slip speed, k_e [m^3/J] worn volume of this
/// surface per work of friction. Zero without load, slip or friction. Over an arc it is the volume k_e ∫ |μ F v| dt,
/// k_e times the friction loss. Fouvry et al. 2003.
struct EnergyWear {
  double coefficient = kRequired;  ///< k_e [m^3/J], that is [1/Pa]

  static constexpr std::string_view kName = "energy_wear";
  static constexpr std::string_view kFormula = "ḣ = k_e |μ| p |v|";
  static constexpr std::array<Parameter<EnergyWear>, 1> kParameters{{
      {"coefficient", "k_e", dimension::kPerPressure, kNotNegative, "worn volume per work of friction",
       &EnergyWear::coefficient},
  }};

  [[nodiscard]] EnergyWear share_of(double share) const { return {share * coefficient}; }

  double operator()(const WearContact& contact) const noexcept {
    return coefficient * contact.friction_coefficient * contact.pressure * contact.slip_speed;
  }
};
static_assert(WearLaw<EnergyWear>);

}  // namespace gudgeon
