// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Archard: wear depth grows with pressure and sliding distance.
#pragma once

#include <array>

#include "gudgeon/laws/wear/wear.h"

namespace gudgeon {

/// ḣ = k_d p |v|
///
/// p [Pa] contact pressure, |v| [m/s] slip speed, k_d [1/Pa] linear wear coefficient of this surface. Zero without load
/// or slip. Archard 1953; eqs. (25), (29) and (30) of the nine-bar paper, k_d = k/H.
struct Archard {
  double coefficient = kRequired;  ///< k_d [1/Pa]

  static constexpr std::string_view kName = "archard";
  static constexpr std::string_view kFormula = "ḣ = k_d p |v|";
  static constexpr std::array<Parameter<Archard>, 1> kParameters{{
      {"coefficient", "k_d", dimension::kPerPressure, kNotNegative, "linear wear coefficient", &Archard::coefficient},
  }};

  [[nodiscard]] Archard share_of(double share) const { return {share * coefficient}; }

  double operator()(const WearContact& contact) const noexcept {
    return coefficient * contact.pressure * contact.slip_speed;
  }
};
static_assert(WearLaw<Archard>);

}  // namespace gudgeon
