// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Curves in their frame.
#include "gudgeon/report/plot/plot_figure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/report/plot/plot_frame.h"

namespace gudgeon {

namespace {

constexpr double kLeftMargin = 74.0;   // [px] room for "−1000.0"
constexpr double kRightMargin = 24.0;  // [px] half a tick's number
constexpr double kTitleHeight = 40.0;
constexpr double kLabelHeight = 24.0;
constexpr double kFootHeight = 52.0;
constexpr double kSideMargin = 12.0;
constexpr double kCaptionSize = 11.0;
constexpr double kCaptionRow = 16.0;

/// The runs of points that have numbers: a gap in the values is a gap in the line.
std::vector<std::vector<Vec2>> split_at_gaps(const std::vector<Vec2>& points) {
  std::vector<std::vector<Vec2>> pieces(1);
  for (const Vec2& point : points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) {
      pieces.back().push_back(point);
    } else if (!pieces.back().empty()) {
      pieces.emplace_back();
    }
  }
  return pieces;
}

/// The caption in lines that fit: a picture on its own needs what one has to know to read it.
std::vector<std::string> break_caption(std::string_view caption, double width) {
  std::vector<std::string> lines;
  while (!caption.empty()) {
    const std::size_t end = std::min(caption.find(' '), caption.size());
    const std::string word(caption.substr(0, end));
    caption.remove_prefix(std::min(end + 1, caption.size()));
    if (!lines.empty() && find_text_width(lines.back() + ' ' + word, kCaptionSize) <= width) {
      lines.back() += ' ' + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

void draw_curve(SvgCanvas& canvas, const DrawnCurve& drawn, const PlotFrame& frame, FigureKind kind) {
  const FigureCurve& curve = *drawn.curve;
  const std::string_view color = find_curve_color(curve.color);
  if (curve.points) {
    for (const Vec2& point : drawn.points) {
      if (std::isfinite(point.x + point.y)) canvas.add_circle(frame.place(point), 2.8, {.fill = color});
    }
    return;
  }
  const bool is_sorted = kind == FigureKind::time || kind == FigureKind::line;
  for (const std::vector<Vec2>& piece : split_at_gaps(drawn.points)) {
    std::vector<Vec2> places =
        is_sorted ? reduce_columns(piece, frame.x.begin, frame.x.end, 2 * static_cast<int>(frame.size.x)) : piece;
    for (Vec2& point : places) point = frame.place(point);
    canvas.add_polyline(
        places, {.stroke = color, .width = kind == FigureKind::phase ? 1.0 : 1.4, .dashes = find_dashes(curve.line)});
  }
}

}  // namespace

std::string plot_figure(const Figure& figure, const PlotSettings& settings) {
  const std::vector<DrawnCurve> curves = find_drawn_curves(figure, settings.cycles);
  const double inner_width = settings.width - kLeftMargin - kRightMargin;
  const double top = kTitleHeight + find_legend_height(curves, inner_width) + kLabelHeight;
  const bool is_plane = figure.kind == FigureKind::plane;
  const double inner_height = is_plane ? inner_width : settings.height - kTitleHeight - kLabelHeight - kFootHeight;
  PlotFrame frame = make_frame(figure.kind, curves, {kLeftMargin, top}, {inner_width, inner_height});
  if (figure.kind == FigureKind::line && figure.x_end > figure.x_begin) {
    frame.x = {figure.x.factor * figure.x_begin, figure.x.factor * figure.x_end};
  }

  const std::vector<std::string> caption = break_caption(figure.caption, settings.width - 2.0 * kSideMargin);
  const double foot = top + inner_height + kFootHeight;
  const double caption_height = caption.empty() ? 0.0 : kCaptionRow * (static_cast<double>(caption.size()) + 0.5);
  SvgCanvas canvas(settings.width, foot + caption_height, figure.title);
  canvas.add_text({kSideMargin, 26.0}, figure.title, {.color = "#1f2933", .size = 16.0, .bold = true});
  draw_legend(canvas, curves, {kSideMargin, kTitleHeight}, inner_width);
  draw_axes(canvas, figure, frame);
  for (const DrawnCurve& curve : curves) draw_curve(canvas, curve, frame, figure.kind);
  for (std::size_t k = 0; k < caption.size(); ++k) {
    canvas.add_text({kSideMargin, foot + kCaptionRow * (static_cast<double>(k) + 0.6)}, caption[k],
                    {.color = "#1f2933", .size = kCaptionSize});
  }
  return canvas.render();
}

}  // namespace gudgeon
