// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers by chance, the same on every machine: what the standard makes of a generator's bits is the library's choice.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "gudgeon/base/vec2.h"

namespace gudgeon::random {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}

  /// From low to high.
  double between(double low, double high) {
    constexpr double kUnit = 0x1.0p-53;
    return low + (high - low) * kUnit * static_cast<double>(bits_() >> 11U);
  }
  /// The same, every factor alike.
  double scaled(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  /// 0 to n − 1.
  int below(int n) { return static_cast<int>(between(0.0, n)); }
  bool with_chance(double chance) { return between(0.0, 1.0) < chance; }
  double angle() { return between(-3.0, 3.0); }
  /// Of that length, in any direction.
  Vec2 vector(double low, double high) {
    const double length = between(low, high);
    const double direction = angle();
    return {length * std::cos(direction), length * std::sin(direction)};
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace gudgeon::random
