// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The frame of a plot: where values land on the sheet, axes, grid and legend.
#pragma once

#include <span>

#include "gudgeon/base/vec2.h"
#include "gudgeon/report/figures/figure.h"
#include "gudgeon/report/plot/drawn_curves.h"
#include "gudgeon/report/svg_canvas.h"

namespace gudgeon {

/// A range of values along an axis, in display units.
struct AxisRange {
  double begin = 0.0;
  double end = 1.0;
  [[nodiscard]] double length() const { return end - begin; }
};

struct PlotFrame {
  Vec2 corner;  ///< [px] upper left of the plotting area
  Vec2 size;    ///< [px]
  AxisRange x;
  AxisRange y;

  [[nodiscard]] Vec2 place(Vec2 value) const {
    return {corner.x + size.x * (value.x - x.begin) / x.length(),
            corner.y + size.y * (1.0 - (value.y - y.begin) / y.length())};
  }
};

/// Ranges that hold all the points, with room around them; one scale for both axes of a plane figure.
PlotFrame make_frame(FigureKind kind, std::span<const DrawnCurve> curves, Vec2 corner, Vec2 size);

/// One entry of the legend a group, in rows no wider than the frame; returns their height [px].
double draw_legend(SvgCanvas& canvas, std::span<const DrawnCurve> curves, Vec2 corner, double width);
double find_legend_height(std::span<const DrawnCurve> curves, double width);

/// Grid, ticks with numbers, labels.
void draw_axes(SvgCanvas& canvas, const Figure& figure, const PlotFrame& frame);

}  // namespace gudgeon
