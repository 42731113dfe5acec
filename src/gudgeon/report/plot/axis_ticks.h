// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Round numbers along an axis.
#pragma once

#include <string>
#include <vector>

namespace gudgeon {

struct AxisTicks {
  std::vector<double> places;
  int decimals = 0;
};

/// Multiples of 1, 2 or 5 times a power of ten within [begin, end], about as many as wanted; of wide ranges in degrees
/// multiples of a divisor of the turn.
AxisTicks find_ticks(double begin, double end, int wanted, bool in_degrees = false);

/// "-0.25" with a true minus sign.
std::string print_tick(double value, int decimals);

}  // namespace gudgeon
