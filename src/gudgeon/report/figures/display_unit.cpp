// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Choosing prefixes by magnitude.
#include "gudgeon/report/figures/display_unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gudgeon {

namespace {

struct AxisPrefix {
  const char* unit;
  double below;  ///< taken for magnitudes below this
  const char* display_unit;
  double factor;
};

// The largest number on an axis has one to three digits before the point.
constexpr std::array kAxisPrefixes{
    AxisPrefix{"m", 1e-6, "nm", 1e9},    AxisPrefix{"m", 1e-3, "µm", 1e6},
    AxisPrefix{"m", 1.0, "mm", 1e3},     AxisPrefix{"m/s", 1e-3, "µm/s", 1e6},
    AxisPrefix{"m/s", 1.0, "mm/s", 1e3}, AxisPrefix{"N", 1e-3, "µN", 1e6},
    AxisPrefix{"N", 1.0, "mN", 1e3},     AxisPrefix{"N", 1e4, "N", 1.0},
    AxisPrefix{"N", 1e7, "kN", 1e-3},    AxisPrefix{"rad", 1e300, "°", 180.0 / std::numbers::pi},
};

double find_largest(const Numbers& numbers) {
  double largest = 0.0;
  if (!numbers) return largest;
  for (const double value : *numbers) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

}  // namespace

FigureAxis make_axis(std::string label, const std::string& unit, double magnitude) {
  FigureAxis axis{std::move(label), unit, unit, 1.0};
  const auto fits = [&](const AxisPrefix& prefix) { return unit == prefix.unit && magnitude < prefix.below; };
  const auto* const found = std::ranges::find_if(kAxisPrefixes, fits);
  if (magnitude > 0.0 && found != kAxisPrefixes.end()) {
    axis.display_unit = found->display_unit;
    axis.factor = found->factor;
  }
  return axis;
}

FigureAxis make_x_axis(std::string label, const std::string& unit, std::span<const FigureCurve> curves) {
  double largest = 0.0;
  for (const FigureCurve& curve : curves) largest = std::max(largest, find_largest(curve.x));
  return make_axis(std::move(label), unit, largest);
}

FigureAxis make_y_axis(std::string label, const std::string& unit, std::span<const FigureCurve> curves) {
  double largest = 0.0;
  for (const FigureCurve& curve : curves) largest = std::max(largest, find_largest(curve.y));
  return make_axis(std::move(label), unit, largest);
}

std::string print_unit(std::string unit) {
  for (const auto& [plain, printed] : {std::pair{"^2", "²"}, std::pair{"^3", "³"}}) {
    for (std::size_t at = unit.find(plain); at != std::string::npos; at = unit.find(plain))
      unit.replace(at, 2, printed);
  }
  return unit;
}

std::string print_axis(const FigureAxis& axis) {
  if (axis.display_unit.empty() || axis.display_unit == "1") return axis.label;
  return axis.label + " (" + print_unit(axis.display_unit) + ")";
}

std::string capitalize(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace gudgeon
