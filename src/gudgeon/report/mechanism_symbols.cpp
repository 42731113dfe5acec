// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The signs of kinematics.
#include "gudgeon/report/mechanism_symbols.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gudgeon {
namespace {

constexpr double kHeadLength = 11.0;
constexpr double kHeadHalfWidth = 4.5;

void draw_head(SvgCanvas& canvas, Vec2 tip, Vec2 way, std::string_view color) {
  const Vec2 base = tip - kHeadLength * way;
  const Vec2 side = kHeadHalfWidth * perp(way);
  const std::array<Vec2, 3> corners = {tip, base + side, base - side};
  canvas.add_polygon(corners, {.fill = color, .stroke = color, .width = 1.0});
}

/// Short slanted strokes below a fixed line.
void draw_hatching(SvgCanvas& canvas, Vec2 center, Vec2 along, Vec2 below, double half_length) {
  constexpr double kSpacing = 8.0;
  constexpr double kDepth = 8.0;
  const int n_strokes = static_cast<int>(2.0 * half_length / kSpacing);
  for (int i = 0; i < n_strokes; ++i) {
    const Vec2 top = center + ((i + 1) * kSpacing - half_length) * along;
    canvas.add_line(top, top - kDepth * along + kDepth * below, {.stroke = ink::kGround, .width = 1.2});
  }
}

}  // namespace

std::vector<Vec2> find_convex_hull(std::vector<Vec2> points) {
  const auto before = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::ranges::sort(points, before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  const Vec2 spread = points.back() - points.front();
  // A corner that stands out by less than a billionth of the size is rounding, not shape.
  const double least_turn = 1e-9 * dot(spread, spread);
  std::vector<Vec2> hull;
  const auto walk = [&](auto first, auto last) {
    const std::size_t n_kept = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= n_kept + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= least_turn) {
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();  // the other half starts with it
  };
  walk(points.begin(), points.end());
  walk(points.rbegin(), points.rend());
  return hull;
}

void draw_plate(SvgCanvas& canvas, const std::vector<Vec2>& corners, const BodyColors& colors) {
  if (corners.size() == 1) {
    canvas.add_circle(corners[0], 0.5 * kBarWidth + 3.0, {.fill = colors.fill, .stroke = colors.outline, .width = 1.5});
    return;
  }
  // A wide stroke in the outline's colour under a narrower one in the fill's makes a rounded shape.
  canvas.add_polygon(corners, {.fill = colors.outline, .stroke = colors.outline, .width = kBarWidth + 3.0});
  canvas.add_polygon(corners, {.fill = colors.fill, .stroke = colors.fill, .width = kBarWidth});
}

void draw_support(SvgCanvas& canvas, Vec2 pivot) {
  constexpr double kHalfWidth = 17.0;
  const Vec2 foot = pivot + Vec2{0.0, kSupportHeight};
  const std::array<Vec2, 3> corners = {pivot, foot + Vec2{-kHalfWidth, 0.0}, foot + Vec2{kHalfWidth, 0.0}};
  canvas.add_polygon(corners, {.fill = "#e4e7eb", .stroke = ink::kGround, .width = 1.6});
  draw_ground_line(canvas, foot, {1.0, 0.0}, {0.0, 1.0}, kHalfWidth + 9.0);
}

void draw_ground_line(SvgCanvas& canvas, Vec2 center, Vec2 along, Vec2 below, double half_length) {
  draw_hatching(canvas, center, along, below, half_length);
  canvas.add_line(center - half_length * along, center + half_length * along, {.stroke = ink::kGround, .width = 2.0});
}

void draw_block(SvgCanvas& canvas, Vec2 center, Vec2 along, const BodyColors& colors) {
  const Vec2 a = kBlockHalfSize.x * along;
  const Vec2 b = kBlockHalfSize.y * perp(along);
  const std::array<Vec2, 4> corners = {center - a - b, center + a - b, center + a + b, center - a + b};
  canvas.add_polygon(corners, {.fill = colors.fill, .stroke = colors.outline, .width = 1.8});
}

void draw_revolute(SvgCanvas& canvas, Vec2 center) {
  canvas.add_circle(center, kJointRadius, {.fill = ink::kPaper, .stroke = ink::kLine, .width = 1.8});
}

void draw_clearance(SvgCanvas& canvas, Vec2 center) {
  canvas.add_circle(center, kClearanceRadius, {.fill = ink::kPaper, .stroke = ink::kClearance, .width = 2.4});
  canvas.add_circle(center, 0.5 * kClearanceRadius, {.fill = "#ffd8a8", .stroke = ink::kClearance, .width = 1.8});
}

// A wide stroke under a narrower one leaves the outline; its round caps are the ends.
void draw_slot_outline(SvgCanvas& canvas, Vec2 from, Vec2 to, double half_width, std::string_view color) {
  constexpr double kOutline = 2.2;
  const std::array<Vec2, 2> ends = {from, to};
  canvas.add_polygon(ends, {.stroke = color, .width = 2.0 * (half_width + kOutline)});
}

void draw_slot_inside(SvgCanvas& canvas, Vec2 from, Vec2 to, double half_width) {
  const std::array<Vec2, 2> ends = {from, to};
  canvas.add_polygon(ends, {.stroke = ink::kPaper, .width = 2.0 * half_width});
}

void draw_pin(SvgCanvas& canvas, Vec2 center, bool has_clearance) {
  if (!has_clearance) return draw_revolute(canvas, center);
  canvas.add_circle(center, kJointRadius, {.fill = "#ffd8a8", .stroke = ink::kClearance, .width = 1.8});
}

void draw_rigid(SvgCanvas& canvas, Vec2 center) {
  const double r = kJointRadius;
  const std::array<Vec2, 4> corners = {center + Vec2{-r, -r}, center + Vec2{r, -r}, center + Vec2{r, r},
                                       center + Vec2{-r, r}};
  canvas.add_polygon(corners, {.fill = ink::kLine, .stroke = ink::kLine, .width = 1.0});
}

void draw_arrow(SvgCanvas& canvas, Vec2 from, Vec2 to, std::string_view color) {
  const Vec2 way = (1.0 / norm(to - from)) * (to - from);
  canvas.add_line(from, to - kHeadLength * way, {.stroke = color, .width = 2.2});
  draw_head(canvas, to, way, color);
}

void draw_turn_arrow(SvgCanvas& canvas, Vec2 center, double from, double to, std::string_view color) {
  const double sense = to > from ? 1.0 : -1.0;
  const double head_angle = sense * kHeadLength / kDriverRadius;
  canvas.add_arc(center, kDriverRadius, from, to - head_angle, {.stroke = color, .width = 2.2});
  // The head follows the chord of the arc it stands for.
  const Vec2 tip = center + kDriverRadius * Vec2{std::cos(to), -std::sin(to)};
  const double chord = to - 0.5 * head_angle;
  draw_head(canvas, tip, sense * Vec2{-std::sin(chord), -std::cos(chord)}, color);
}

}  // namespace gudgeon
