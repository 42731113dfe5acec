// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Equality of doubles to the last bit, NaN and the sign of zero included.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace gudgeon::test {

inline bool have_same_bits(std::span<const double> a, std::span<const double> b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

}  // namespace gudgeon::test
