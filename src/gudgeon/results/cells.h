// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cells of a circumference: cell k of n covers the angles from 2π k/n to 2π (k + 1)/n in the body's own axes. Of a
// slot's side: it covers the lengths from L k/n to L (k + 1)/n from the rear end.
#pragma once

#include <cstddef>
#include <numbers>

namespace gudgeon {

/// [rad] of the middle of cell k of n.
constexpr double find_cell_angle(std::size_t k, std::size_t n) {
  return 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n);
}

/// [m] of the middle of cell k of n of a slot's side, from the middle of the slot.
constexpr double find_cell_position(std::size_t k, std::size_t n, double length) {
  return length * ((static_cast<double>(k) + 0.5) / static_cast<double>(n) - 0.5);
}

}  // namespace gudgeon
