// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Archard whose coefficient settles as the joint slides.
#pragma once

#include <array>
#include <cmath>

#include "gudgeon/laws/wear/wear.h"

namespace gudgeon {

/// ḣ = [k_∞ + (k₀ − k_∞) exp(−s/s_r)] p |v|
///
/// p [Pa] contact pressure, |v| [m/s] slip speed, s [m] distance slid in this joint so far, times the wear
/// acceleration, k₀ and k_∞ [1/Pa] linear wear coefficient of the new and of the run-in surface, s_r [m] distance over
/// which it runs in. s = 0: archard with k₀; s ≫ s_r: archard with k_∞. The whole joint runs in at once, also within a
/// stage. The volume at constant load is F [k_∞ s + (k₀ − k_∞) s_r (1 − exp(−s/s_r))], the exponential transient of
/// Queener et al. 1965.
struct RunningInDistance {
  double initial_coefficient = kRequired;  ///< k₀ [1/Pa]
  double steady_coefficient = kRequired;   ///< k_∞ [1/Pa]
  double running_in_distance = kRequired;  ///< s_r [m]

  static constexpr std::string_view kName = "running_in_distance";
  static constexpr std::string_view kFormula = "ḣ = [k_∞ + (k₀ − k_∞) exp(−s/s_r)] p |v|";
  static constexpr std::array<Parameter<RunningInDistance>, 3> kParameters{{
      {"initial_coefficient", "k₀", dimension::kPerPressure, kNotNegative, "linear wear coefficient of the new surface",
       &RunningInDistance::initial_coefficient},
      {"steady_coefficient", "k_∞", dimension::kPerPressure, kNotNegative, "linear wear coefficient once run in",
       &RunningInDistance::steady_coefficient},
      {"running_in_distance", "s_r", dimension::kLength, kPositive, "sliding distance over which the joint runs in",
       &RunningInDistance::running_in_distance},
  }};

  /// The coefficients are shared; s_r is each surface's own.
  [[nodiscard]] RunningInDistance share_of(double share) const {
    return {share * initial_coefficient, share * steady_coefficient, running_in_distance};
  }

  double operator()(const WearContact& contact) const noexcept {
    const double newness = std::exp(-contact.sliding_distance / running_in_distance);
    const double coefficient = steady_coefficient + (initial_coefficient - steady_coefficient) * newness;
    return coefficient * contact.pressure * contact.slip_speed;
  }
};
static_assert(WearLaw<RunningInDistance>);

}  // namespace gudgeon
