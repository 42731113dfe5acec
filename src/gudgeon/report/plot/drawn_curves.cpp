// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Choosing and thinning points.
#include "gudgeon/report/plot/drawn_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gudgeon {

namespace {

std::size_t find_first_shown(const FigureCurve& curve, double cycles) {
  const std::size_t n = curve.x->size();
  if (curve.cycle_samples == 0 || !(cycles > 0.0)) return 0;
  const auto wanted = static_cast<std::size_t>(std::ceil(cycles * static_cast<double>(curve.cycle_samples))) + 1;
  return n > wanted ? n - wanted : 0;
}

}  // namespace

std::vector<DrawnCurve> find_drawn_curves(const Figure& figure, double cycles) {
  const bool has_range = figure.kind == FigureKind::line && figure.x_end > figure.x_begin;
  std::vector<DrawnCurve> drawn;
  for (const FigureCurve& curve : figure.curves) {
    if (!curve.shown) continue;
    DrawnCurve& one = drawn.emplace_back(DrawnCurve{&curve, {}});
    for (std::size_t k = find_first_shown(curve, cycles); k < curve.x->size(); ++k) {
      const double x = (*curve.x)[k];
      if (has_range && (x < figure.x_begin || x > figure.x_end)) continue;
      one.points.push_back({figure.x.factor * x, figure.y.factor * (*curve.y)[k]});
    }
  }
  return drawn;
}

std::vector<Vec2> reduce_columns(const std::vector<Vec2>& points, double begin, double end, int n_columns) {
  if (points.size() <= static_cast<std::size_t>(4 * n_columns) || !(end > begin)) return points;
  const auto find_column = [&](const Vec2& p) {
    return static_cast<int>(std::clamp((p.x - begin) / (end - begin) * n_columns, -1.0, n_columns + 1.0));
  };
  const auto lower = [](const Vec2& a, const Vec2& b) { return a.y < b.y; };
  std::vector<Vec2> kept;
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first + 1;
    while (last < points.size() && find_column(points[last]) == find_column(points[first])) ++last;
    const auto from = points.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = points.begin() + static_cast<std::ptrdiff_t>(last);
    const auto [least, greatest] = std::minmax_element(from, to, lower);
    std::array chosen{from, std::min(least, greatest), std::max(least, greatest), to - 1};
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (k == 0 || chosen[k] != chosen[k - 1]) kept.push_back(*chosen[k]);
    }
    first = last;
  }
  return kept;
}

std::string_view find_curve_color(int k) {
  // After Okabe and Ito, the yellow darkened so that it shows on white.
  static constexpr std::array<std::string_view, 8> kColors{"#6b7280", "#0072b2", "#d55e00", "#009e73",
                                                           "#cc79a7", "#b8860b", "#56b4e9", "#7f3fbf"};
  return k <= 0 ? kColors[0] : kColors[1 + static_cast<std::size_t>(k - 1) % (kColors.size() - 1)];
}

std::string_view find_dashes(LineStyle line) {
  static constexpr std::array<std::string_view, 4> kDashes{"", "5 5", "1.5 3", "9 3 2 3"};
  return kDashes[static_cast<std::size_t>(line)];
}

}  // namespace gudgeon
