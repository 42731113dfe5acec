// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Archard with a coefficient without unit and the hardness of the surface.
#pragma once

#include <array>

#include "gudgeon/laws/wear/wear.h"

namespace gudgeon {

/// ḣ = k p |v|/H
///
/// p [Pa] contact pressure, |v| [m/s] slip speed, k [1] wear coefficient, H [Pa] hardness of this surface. Zero without
/// load or slip; that of archard with k_d = k/H. Over an arc it is the volume k F s/H. Archard 1953.
struct ArchardHardness {
  double coefficient = kRequired;  ///< k [1]
  double hardness = kRequired;     ///< H [Pa]

  static constexpr std::string_view kName = "archard_hardness";
  static constexpr std::string_view kFormula = "ḣ = k p |v|/H";
  static constexpr std::array<Parameter<ArchardHardness>, 2> kParameters{{
      {"coefficient", "k", dimension::kNone, kNotNegative, "wear coefficient", &ArchardHardness::coefficient},
      {"hardness", "H", dimension::kPressure, kPositive, "hardness of the surface", &ArchardHardness::hardness},
  }};

  [[nodiscard]] ArchardHardness share_of(double share) const { return {share * coefficient, hardness}; }

  double operator()(const WearContact& contact) const noexcept {
    return coefficient / hardness * contact.pressure * contact.slip_speed;
  }
};
static_assert(WearLaw<ArchardHardness>);

}  // namespace gudgeon
