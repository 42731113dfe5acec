// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A sheet of SVG: strokes, shapes and text in pixels, y downwards.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

/// How a shape is drawn; an empty colour draws nothing.
struct Paint {
  std::string_view fill = "none";
  std::string_view stroke = "none";
  double width = 1.0;  ///< [px] of the stroke
  std::string_view dashes = {};
};

enum class TextAnchor { start, middle, end };

struct TextStyle {
  std::string_view color = "#000000";
  double size = 13.0;  ///< [px]
  bool bold = false;
  bool italic = false;
  TextAnchor anchor = TextAnchor::start;
  std::string_view halo = "#ffffff";  ///< colour around the letters
};

class SvgCanvas {
 public:
  SvgCanvas(double width, double height, std::string_view title);

  void add_line(Vec2 from, Vec2 to, const Paint& paint);
  void add_polyline(std::span<const Vec2> points, const Paint& paint);
  void add_polygon(std::span<const Vec2> points, const Paint& paint);
  void add_circle(Vec2 center, double radius, const Paint& paint);
  /// The arc from one angle to another, both [rad] and counter-clockwise as seen on the sheet.
  void add_arc(Vec2 center, double radius, double from, double to, const Paint& paint);
  /// Text on a halo, its baseline at the given place; one wider than the sheet is cut at its edge.
  void add_text(Vec2 baseline, std::string_view text, const TextStyle& style);
  void begin_group(std::string_view name);
  void end_group();

  /// The whole document.
  [[nodiscard]] std::string render() const;

 private:
  [[nodiscard]] std::string fit_text(Vec2 baseline, std::string_view text, const TextStyle& style) const;
  double width_;
  double height_;
  std::string title_;
  std::string body_;
};

/// Width of a text [px], as near as it can be known without the font.
double find_text_width(std::string_view text, double size, bool bold = false);

}  // namespace gudgeon
