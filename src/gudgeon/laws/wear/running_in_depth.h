// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Archard whose coefficient settles as the surface loses depth.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/wear/wear.h"

namespace gudgeon {

/// ḣ = [k_∞ + (k₀ − k_∞) exp(−h/h_r)] p |v|
///
/// p [Pa] contact pressure, |v| [m/s] slip speed, h [m] depth that this surface has lost here before this stage, k₀ and
/// k_∞ [1/Pa] linear wear coefficient of the new and of the run-in surface, h_r [m] depth over which it runs in. h = 0:
/// archard with k₀; h ≫ h_r: archard with k_∞. Every place of a surface runs in by itself. h is the slow state: within
/// a stage the coefficient stays the same. The form of running_in_distance, taken
/// over depth.
struct RunningInDepth {
  double initial_coefficient = kRequired;  ///< k₀ [1/Pa]
  double steady_coefficient = kRequired;   ///< k_∞ [1/Pa]
  double running_in_depth = kRequired;     ///< h_r [m]

  static constexpr std::string_view kName = "running_in_depth";
  static constexpr std::string_view kFormula = "ḣ = [k_∞ + (k₀ − k_∞) exp(−h/h_r)] p |v|";
  static constexpr std::array<Parameter<RunningInDepth>, 3> kParameters{{
      {"initial_coefficient", "k₀", dimension::kPerPressure, kNotNegative, "linear wear coefficient of the new surface",
       &RunningInDepth::initial_coefficient},
      {"steady_coefficient", "k_∞", dimension::kPerPressure, kNotNegative, "linear wear coefficient once run in",
       &RunningInDepth::steady_coefficient},
      {"running_in_depth", "h_r", dimension::kLength, kPositive, "wear depth over which the surface runs in",
       &RunningInDepth::running_in_depth},
  }};

  /// The coefficients are shared; h_r is each surface's own.
  [[nodiscard]] RunningInDepth share_of(double share) const {
    return {share * initial_coefficient, share * steady_coefficient, running_in_depth};
  }

  double operator()(const WearContact& contact) const noexcept {
    const double newness = std::exp(-contact.depth / running_in_depth);
    const double coefficient = steady_coefficient + (initial_coefficient - steady_coefficient) * newness;
    return coefficient * contact.pressure * contact.slip_speed;
  }
};
static_assert(WearLaw<RunningInDepth>);

}  // namespace gudgeon
