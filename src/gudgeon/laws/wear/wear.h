// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The family of wear laws: how fast a sliding surface loses depth.
#pragma once

#include <concepts>

#include "gudgeon/laws/law.h"

namespace gudgeon {

/// What wear of one surface depends on, at one place and instant.
struct WearContact {
  double pressure;                    ///< p [Pa]
  double slip_speed;                  ///< |v| [m/s]
  double friction_coefficient = 0.0;  ///< |μ| [1], so that μ p |v| is the friction power of a unit of area
  double depth = 0.0;                 ///< h [m] that this surface has lost here before this stage
  double sliding_distance = 0.0;      ///< s [m] slid in this joint up to now, times the wear acceleration
};

/// A wear law maps them to the rate of depth loss ḣ [m/s], >= 0, proportional to the pressure: the volume lost over an
/// arc then does not depend on how the force is spread over it. NaN in, NaN out, unless nothing wears. share_of(x) is
/// the law of a surface that takes the share x in [0, 1] of the wear.
template <class Law>
concept WearLaw = LawValue<Law> && requires(const Law law, const WearContact contact) {
  { law(contact) }
  noexcept->std::same_as<double>;
  { law.share_of(0.5) } -> std::same_as<Law>;
};

}  // namespace gudgeon
