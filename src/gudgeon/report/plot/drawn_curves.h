// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The part of each curve that a plot shows, in display units.
#pragma once

#include <string_view>
#include <vector>

#include "gudgeon/base/vec2.h"
#include "gudgeon/report/figures/figure.h"

namespace gudgeon {

struct DrawnCurve {
  const FigureCurve* curve = nullptr;
  std::vector<Vec2> points;  ///< in display units
};

/// Of recorded signals the last cycles, of others all; what lies beyond the figure's first x range is left out.
std::vector<DrawnCurve> find_drawn_curves(const Figure& figure, double cycles);

/// Keeps of each column of the sheet the first, least, greatest and last value: the line looks the same and no peak is
/// lost. Points must be sorted along x.
std::vector<Vec2> reduce_columns(const std::vector<Vec2>& points, double begin, double end, int n_columns);

/// Colour k of a palette that colour-blind readers can tell apart; 0 is the neutral one.
std::string_view find_curve_color(int k);

/// As SVG has them; empty for a solid line.
std::string_view find_dashes(LineStyle line);

}  // namespace gudgeon
