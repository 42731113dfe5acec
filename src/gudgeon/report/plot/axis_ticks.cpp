// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Ticks at round numbers.
#include "gudgeon/report/plot/axis_ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gudgeon {

AxisTicks find_ticks(double begin, double end, int wanted, bool in_degrees) {
  AxisTicks ticks;
  if (!(end > begin) || !std::isfinite(end - begin) || wanted < 1) return ticks;
  const double raw = (end - begin) / wanted;
  const double exponent = std::floor(std::log10(raw));
  const double decade = std::pow(10.0, exponent);
  const double part = raw / decade;
  double step = decade * (part <= 1.0 ? 1.0 : (part <= 2.0 ? 2.0 : (part <= 5.0 ? 5.0 : 10.0)));
  static constexpr std::array kDegrees{10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0};
  if (in_degrees && raw > 5.0 && raw <= kDegrees.back()) step = *std::ranges::lower_bound(kDegrees, raw);
  ticks.decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));  // log10(1e-3) may round down
  const double slack = 1e-9 * step;  // a tick on the very end belongs to the axis, whatever rounding says
  for (double k = std::ceil((begin - slack) / step); k * step <= end + slack; k += 1.0) {
    ticks.places.push_back(k == 0.0 ? 0.0 : k * step);
  }
  return ticks;
}

std::string print_tick(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !is_zero ? "−" + text : text;
}

}  // namespace gudgeon
