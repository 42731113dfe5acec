// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// SVG elements as text.
#include "gudgeon/report/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "gudgeon/base/shown_text.h"

namespace gudgeon {
namespace {

/// The text with the characters that XML keeps for itself written as entities.
std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : show_controls(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

/// A coordinate with two decimals, no trailing zeros and no minus before zero.
std::string format(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string render_paint(const Paint& paint) {
  std::string text = fmt::format("fill=\"{}\"", paint.fill);
  if (paint.stroke != "none") {
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", paint.stroke, format(paint.width));
  }
  if (!paint.dashes.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", paint.dashes);
  return text;
}

std::string render_points(std::span<const Vec2> points) {
  std::string text;
  for (const Vec2 point : points) {
    if (!text.empty()) text += ' ';
    text += format(point.x) + ',' + format(point.y);
  }
  return text;
}

}  // namespace

SvgCanvas::SvgCanvas(double width, double height, std::string_view title)
    : width_(width), height_(height), title_(title) {}

void SvgCanvas::add_line(Vec2 from, Vec2 to, const Paint& paint) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", format(from.x), format(from.y),
                       format(to.x), format(to.y), render_paint(paint));
}

void SvgCanvas::add_polyline(std::span<const Vec2> points, const Paint& paint) {
  body_ += fmt::format("<polyline points=\"{}\" {}/>\n", render_points(points), render_paint(paint));
}

void SvgCanvas::add_polygon(std::span<const Vec2> points, const Paint& paint) {
  body_ += fmt::format("<polygon points=\"{}\" {}/>\n", render_points(points), render_paint(paint));
}

void SvgCanvas::add_circle(Vec2 center, double radius, const Paint& paint) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", format(center.x), format(center.y),
                       format(radius), render_paint(paint));
}

void SvgCanvas::add_arc(Vec2 center, double radius, double from, double to, const Paint& paint) {
  const Vec2 start = center + radius * Vec2{std::cos(from), -std::sin(from)};
  const Vec2 end = center + radius * Vec2{std::cos(to), -std::sin(to)};
  const bool is_large = std::abs(to - from) > 3.141592653589793;
  body_ += fmt::format("<path d=\"M{} {} A{} {} 0 {} {} {} {}\" {}/>\n", format(start.x), format(start.y),
                       format(radius), format(radius), is_large ? 1 : 0, to > from ? 0 : 1, format(end.x),
                       format(end.y), render_paint(paint));
}

void SvgCanvas::add_text(Vec2 baseline, std::string_view text, const TextStyle& style) {
  static constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}{} "
      "stroke=\"{}\" stroke-width=\"3\" paint-order=\"stroke\">{}</text>\n",
      format(baseline.x), format(baseline.y), format(style.size), style.color, kAnchors[static_cast<int>(style.anchor)],
      style.bold ? " font-weight=\"bold\"" : "", style.italic ? " font-style=\"italic\"" : "", style.halo,
      escape(fit_text(baseline, text, style)));
}

// Only what no sheet could hold: ordinary texts are placed by whoever adds them.
std::string SvgCanvas::fit_text(Vec2 baseline, std::string_view text, const TextStyle& style) const {
  if (find_text_width(text, style.size, style.bold) <= width_) return std::string(text);
  const double right = width_ - baseline.x;
  const double room = style.anchor == TextAnchor::start ? right
                      : style.anchor == TextAnchor::end ? baseline.x
                                                        : 2.0 * std::min(right, baseline.x);
  const double n_letters = std::max(room / find_text_width("m", style.size, style.bold) - 2.0, 1.0);
  std::string_view rest = text;
  for (int k = 0; k < static_cast<int>(n_letters) && !rest.empty(); ++k) take_code_point(rest);
  return fmt::format("{}…", text.substr(0, text.size() - rest.size()));
}

void SvgCanvas::begin_group(std::string_view name) { body_ += fmt::format("<g class=\"{}\">\n", escape(name)); }

void SvgCanvas::end_group() { body_ += "</g>\n"; }

std::string SvgCanvas::render() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "font-family=\"'DejaVu Sans', Verdana, 'Segoe UI', Helvetica, Arial, sans-serif\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">\n<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" rx=\"8\" fill=\"#ffffff\"/>\n{3}</svg>\n",
      format(width_), format(height_), escape(title_), body_);
}

double find_text_width(std::string_view text, double size, bool bold) {
  // Mean advance of the wider fonts in the list; bytes that continue a UTF-8 character have no width.
  const double advance = bold ? 0.65 : 0.58;
  int n_characters = 0;
  for (const char c : text) n_characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return advance * size * n_characters;
}

}  // namespace gudgeon
