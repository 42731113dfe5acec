// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Regions of a circumference: region k of n covers the angles from 2π k/n to 2π (k + 1)/n in the body's own axes.
#pragma once

#include <cstddef>
#include <numbers>

namespace gudgeon {

/// [rad] of the middle of region k of n.
constexpr double find_region_angle(std::size_t k, std::size_t n) {
  return 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n);
}

}  // namespace gudgeon
