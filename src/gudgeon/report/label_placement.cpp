// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Greedy label placement.
#include "gudgeon/report/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gudgeon {

namespace {

constexpr double kMargin = 2.0;  // [px] that labels keep from what is around them

}  // namespace

double find_overlap(const Box& a, const Box& b) {
  const double width = std::min(a.center.x + a.half_size.x, b.center.x + b.half_size.x) -
                       std::max(a.center.x - a.half_size.x, b.center.x - b.half_size.x);
  const double height = std::min(a.center.y + a.half_size.y, b.center.y + b.half_size.y) -
                        std::max(a.center.y - a.half_size.y, b.center.y - b.half_size.y);
  return std::max(width, 0.0) * std::max(height, 0.0);
}

void LabelPlacer::add_obstacle_line(Vec2 from, Vec2 to, double width) {
  // Boxes half a width apart leave no gap that a label could slip into.
  const int n_boxes = std::max(1, static_cast<int>(2.0 * norm(to - from) / width));
  for (int i = 0; i <= n_boxes; ++i) {
    const Vec2 center = from + (static_cast<double>(i) / n_boxes) * (to - from);
    // Of a slanting line, a full square would claim corners that are free.
    obstacles_.push_back({center, {0.4 * width, 0.4 * width}});
  }
}

// Within the sheet and clear of every other label.
bool LabelPlacer::is_free(const Box& label) const {
  const double area = 4.0 * label.half_size.x * label.half_size.y;
  return find_overlap(label, sheet_) > area - 1e-6 * area &&
         std::ranges::none_of(labels_, [&](const Box& other) { return find_overlap(label, other) > 0.0; });
}

double LabelPlacer::find_covered(const Box& label) const {
  double covered = 0.0;
  for (const Box& obstacle : obstacles_) covered += find_overlap(label, obstacle);
  return covered;
}

std::optional<LabelPlacer::Choice> LabelPlacer::find_candidate(const std::vector<Vec2>& candidates,
                                                               Vec2 half_size) const {
  std::optional<Choice> best;
  double preference = 0.0;
  for (const Vec2 candidate : candidates) {
    const Box label = Box{candidate, half_size}.grown(kMargin);
    const double cost = find_covered(label) + preference;
    if ((!best || cost < best->cost) && is_free(label)) best = {candidate, cost};
    preference += 1.0;
  }
  return best;
}

// Ring by ring: what a place covers counts, and how far it is, most of all up or down, where lines would cross texts.
std::optional<LabelPlacer::Choice> LabelPlacer::find_far_place(Vec2 around, Vec2 half_size) const {
  constexpr int kDirections = 40;
  constexpr double kStep = 7.0;  // [px] from ring to ring
  const double farthest = 2.0 * norm(sheet_.half_size);
  std::optional<Choice> best;
  for (double radius = 2.0 * kStep; radius < farthest && (!best || radius < best->cost); radius += kStep) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const Vec2 way = radius * Vec2{std::cos(angle), std::sin(angle)};
      const Box label = Box{around + way, half_size}.grown(kMargin);
      const double cost = find_covered(label) + std::abs(way.x) + 2.0 * std::abs(way.y);
      if ((!best || cost < best->cost) && is_free(label)) best = {around + way, cost};
    }
  }
  return best;
}

std::optional<LabelPlace> LabelPlacer::place(const std::vector<Vec2>& candidates, Vec2 half_size) {
  constexpr double kCostOfLine = 120.0;  // [px^2] a line to the name is worth covering a third of a short one
  const std::optional<Choice> near = find_candidate(candidates, half_size);
  std::optional<Choice> far;
  if (!near || near->cost > kCostOfLine) far = find_far_place(candidates.front(), half_size);
  const bool is_far = far && (!near || far->cost + kCostOfLine < near->cost);
  if (!near && !far) return std::nullopt;
  const Vec2 center = is_far ? far->center : near->center;
  add_label({center, half_size});
  return LabelPlace{center, is_far};
}

std::vector<Vec2> make_candidates_around(Vec2 spot, double radius, Vec2 half_size) {
  constexpr double kDiagonal = 0.7071;
  constexpr std::array<Vec2, 8> kDirections = {{{kDiagonal, -kDiagonal},
                                                {-kDiagonal, -kDiagonal},
                                                {1, 0},
                                                {-1, 0},
                                                {0, -1},
                                                {kDiagonal, kDiagonal},
                                                {-kDiagonal, kDiagonal},
                                                {0, 1}}};
  std::vector<Vec2> candidates;
  for (const double gap : {2.0, 6.0, 10.0, 15.0, 22.0, 30.0}) {
    for (const Vec2 way : kDirections) {
      // A corner of the label points at the spot on the diagonals, an edge on the axes.
      const Vec2 reach{way.x > 0.1 ? half_size.x : (way.x < -0.1 ? -half_size.x : 0.0),
                       way.y > 0.1 ? half_size.y : (way.y < -0.1 ? -half_size.y : 0.0)};
      candidates.push_back(spot + (radius + gap) * way + reach);
    }
  }
  return candidates;
}

std::vector<Vec2> make_candidates_beside(Vec2 from, Vec2 to, double width, Vec2 half_size) {
  const double length = norm(to - from);
  const Vec2 normal = length > 0.0 ? (1.0 / length) * perp(to - from) : Vec2{0.0, -1.0};
  const double reach = std::abs(normal.x) * half_size.x + std::abs(normal.y) * half_size.y;
  std::vector<Vec2> candidates;
  for (const double gap : {4.0, 10.0, 18.0, 30.0}) {
    for (const double share : {0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74}) {
      for (const double side : {-1.0, 1.0}) {
        candidates.push_back(from + share * (to - from) + side * (0.5 * width + gap + reach) * normal);
      }
    }
  }
  return candidates;
}

}  // namespace gudgeon
