// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Axes of a plot.
#include "gudgeon/report/plot/plot_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gudgeon/report/figures/display_unit.h"
#include "gudgeon/report/plot/axis_ticks.h"

namespace gudgeon {

namespace {

constexpr double kAxisTextSize = 13.0;  // [px]
constexpr double kTickTextSize = 12.0;  // [px]
constexpr double kTickSpacing = 90.0;   // [px] about, along x
constexpr std::string_view kAxisInk = "#1f2933";
constexpr std::string_view kGridInk = "#e4e7eb";
constexpr std::string_view kPlotPaper = "#ffffff";

AxisRange find_axis_range(std::span<const DrawnCurve> curves, double Vec2::*part) {
  AxisRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const DrawnCurve& curve : curves) {
    for (const Vec2& point : curve.points) {
      if (!std::isfinite(point.*part)) continue;
      range.begin = std::min(range.begin, point.*part);
      range.end = std::max(range.end, point.*part);
    }
  }
  return range.end >= range.begin ? range : AxisRange{0.0, 1.0};
}

/// Room around the values; a single value gets room of its own size.
AxisRange widen(AxisRange range, double part) {
  double room = part * range.length();
  if (!(room > 0.0)) room = range.begin != 0.0 ? 0.1 * std::abs(range.begin) : 1.0;
  return {range.begin - room, range.end + room};
}

/// Gives both axes one scale by widening the one that is finer.
void make_equal_scales(PlotFrame& frame) {
  const double scale = std::max(frame.x.length() / frame.size.x, frame.y.length() / frame.size.y);
  const auto fit = [scale](AxisRange& range, double pixels) {
    const double center = 0.5 * (range.begin + range.end);
    range = {center - 0.5 * scale * pixels, center + 0.5 * scale * pixels};
  };
  fit(frame.x, frame.size.x);
  fit(frame.y, frame.size.y);
}

struct LegendEntry {
  std::string_view name;
  const FigureCurve* curve = nullptr;
  Vec2 place;  // [px] of its left end, from the legend's corner
};

constexpr double kLegendRow = 20.0;     // [px]
constexpr double kLegendSample = 22.0;  // [px] of line

std::vector<LegendEntry> lay_out_legend(std::span<const DrawnCurve> curves, double width) {
  std::vector<LegendEntry> entries;
  Vec2 next{0.0, 0.0};
  for (const DrawnCurve& drawn : curves) {
    const bool known = std::ranges::any_of(entries, [&](const LegendEntry& entry) {
      return entry.curve->group == drawn.curve->group &&
             (!drawn.curve->group.empty() || entry.curve->name == drawn.curve->name);
    });
    if (known) continue;
    const double length = kLegendSample + 8.0 + find_text_width(drawn.curve->name, kTickTextSize) + 16.0;
    if (next.x > 0.0 && next.x + length > width) next = {0.0, next.y + kLegendRow};
    entries.push_back({drawn.curve->name, drawn.curve, next});
    next.x += length;
  }
  return entries;
}

}  // namespace

PlotFrame make_frame(FigureKind kind, std::span<const DrawnCurve> curves, Vec2 corner, Vec2 size) {
  PlotFrame frame{corner, size, find_axis_range(curves, &Vec2::x), find_axis_range(curves, &Vec2::y)};
  const bool is_tight = kind == FigureKind::time || kind == FigureKind::line;
  if (!is_tight || !(frame.x.length() > 0.0)) frame.x = widen(frame.x, 0.05);
  frame.y = widen(frame.y, 0.06);
  if (kind == FigureKind::plane) make_equal_scales(frame);
  return frame;
}

double find_legend_height(std::span<const DrawnCurve> curves, double width) {
  const std::vector<LegendEntry> entries = lay_out_legend(curves, width);
  return entries.empty() ? 0.0 : entries.back().place.y + kLegendRow;
}

double draw_legend(SvgCanvas& canvas, std::span<const DrawnCurve> curves, Vec2 corner, double width) {
  for (const LegendEntry& entry : lay_out_legend(curves, width)) {
    const Vec2 left = corner + entry.place + Vec2{0.0, 0.5 * kLegendRow};
    const std::string_view color = find_curve_color(entry.curve->color);
    if (entry.curve->points) {
      canvas.add_circle(left + Vec2{0.5 * kLegendSample, 0.0}, 3.0, {.fill = color});
    } else {
      canvas.add_line(left, left + Vec2{kLegendSample, 0.0},
                      {.stroke = color, .width = 2.0, .dashes = find_dashes(entry.curve->line)});
    }
    canvas.add_text(left + Vec2{kLegendSample + 8.0, 4.5}, entry.name, {.color = kAxisInk, .size = kTickTextSize});
  }
  return find_legend_height(curves, width);
}

void draw_axes(SvgCanvas& canvas, const Figure& figure, const PlotFrame& frame) {
  const Vec2 end = frame.corner + frame.size;
  const AxisTicks x_ticks =
      find_ticks(frame.x.begin, frame.x.end, std::max(2, static_cast<int>(frame.size.x / kTickSpacing)),
                 figure.x.display_unit == "°");
  const AxisTicks y_ticks =
      find_ticks(frame.y.begin, frame.y.end, std::max(2, static_cast<int>(frame.size.y / (0.6 * kTickSpacing))));
  for (const double place : x_ticks.places) {
    const double at = frame.place({place, frame.y.begin}).x;
    canvas.add_line({at, frame.corner.y}, {at, end.y}, {.stroke = kGridInk});
    canvas.add_text({at, end.y + 17.0}, print_tick(place, x_ticks.decimals),
                    {.color = kAxisInk, .size = kTickTextSize, .anchor = TextAnchor::middle, .halo = kPlotPaper});
  }
  for (const double place : y_ticks.places) {
    const double at = frame.place({frame.x.begin, place}).y;
    canvas.add_line({frame.corner.x, at}, {end.x, at}, {.stroke = kGridInk});
    canvas.add_text({frame.corner.x - 7.0, at + 4.2}, print_tick(place, y_ticks.decimals),
                    {.color = kAxisInk, .size = kTickTextSize, .anchor = TextAnchor::end, .halo = kPlotPaper});
  }
  canvas.add_text({0.5 * (frame.corner.x + end.x), end.y + 38.0}, print_axis(figure.x),
                  {.color = kAxisInk, .size = kAxisTextSize, .anchor = TextAnchor::middle});
  // Upright above its axis: as easy to read as the rest.
  canvas.add_text({12.0, frame.corner.y - 9.0}, print_axis(figure.y), {.color = kAxisInk, .size = kAxisTextSize});
  const Vec2 corners[] = {frame.corner, {end.x, frame.corner.y}, end, {frame.corner.x, end.y}};
  canvas.add_polygon(corners, {.stroke = kAxisInk});
}

}  // namespace gudgeon
