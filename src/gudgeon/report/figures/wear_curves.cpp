// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Worn surfaces over their coordinate and in the plane.
#include "gudgeon/report/figures/wear_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "gudgeon/report/figures/display_unit.h"

namespace gudgeon {

namespace {

/// The deepest place of a polar picture reaches about this part of the radius outwards.
constexpr double kDepthShown = 0.25;
/// The unrolled pictures begin with this much to both sides of the deepest place.
constexpr double kEnlargedHalfWidth = 0.7;  // [rad]

FigureCurve make_worn_curve(const WornSurfaces& surfaces, const SurfaceProfile& profile, Numbers x, Numbers y) {
  FigureCurve curve;
  curve.name = surfaces.name;
  curve.group = surfaces.group;
  curve.color = surfaces.color;
  if (profile.part >= 0) {
    // Sides and corners: each has its name, its colour, its line, and is switched by itself.
    curve.name += ", " + profile.name;
    curve.group += "." + profile.name;
    curve.color += profile.part * surfaces.n_alike;
    curve.line = static_cast<LineStyle>(profile.part);
  }
  curve.x = std::move(x);
  curve.y = std::move(y);
  return curve;
}

double find_greatest(const Numbers& depth) { return depth->empty() ? 0.0 : *std::ranges::max_element(*depth); }

/// 1, 2 or 5 times a power of ten, not above the value.
double find_round_factor(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double part = value / decade;
  return decade * (part >= 5.0 ? 5.0 : (part >= 2.0 ? 2.0 : 1.0));
}

/// A closed outline at radius + factor · depth outwards.
FigureCurve make_outline(const WornSurfaces& surfaces, const SurfaceProfile& profile, double factor) {
  std::vector<double> x;
  std::vector<double> y;
  const std::size_t n = profile.depth->size();
  for (std::size_t k = 0; k <= n; ++k) {
    const double radius = profile.radius + profile.outwards * factor * (*profile.depth)[k % n];
    x.push_back(radius * std::cos((*profile.position)[k % n]));
    y.push_back(radius * std::sin((*profile.position)[k % n]));
  }
  return make_worn_curve(surfaces, profile, make_numbers(std::move(x)), make_numbers(std::move(y)));
}

std::vector<SurfaceProfile> split_round(const WornSurfaces& surfaces) {
  if (surfaces.wear->slot_length > 0.0) return {};  // no circle to draw it on
  std::vector<SurfaceProfile> profiles = split_bearing(*surfaces.wear, surfaces.state.bearing_depth);
  std::ranges::copy(split_journal(*surfaces.wear, surfaces.state.journal_depth), std::back_inserter(profiles));
  std::erase_if(profiles, [](const SurfaceProfile& p) { return p.radius <= 0.0 || p.depth->empty(); });
  return profiles;
}

Numbers place_across(const SurfaceProfile& profile) {
  std::vector<double> place;
  for (const double depth : *profile.depth) place.push_back(profile.outwards * depth);
  return make_numbers(std::move(place));
}

std::size_t find_deepest_cell(const SurfaceProfile& profile) {
  return static_cast<std::size_t>(std::ranges::max_element(*profile.depth) - profile.depth->begin());
}

/// A round profile cut open opposite to a cell, so that the place around the cell is whole.
SurfaceProfile cut_opposite(SurfaceProfile profile, std::size_t cell) {
  const std::size_t n = profile.depth->size();
  if (!(profile.radius > 0.0) || n == 0) return profile;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  std::vector<double> position;
  std::vector<double> depth;
  // From half a turn before the cell; angles near it stay within a turn of zero.
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (cell + n - n / 2 + i) % n;
    const double turns = std::floor(static_cast<double>(cell + n - n / 2 + i) / static_cast<double>(n)) - 1.0;
    position.push_back((*profile.position)[k] + kTurn * turns);
    depth.push_back((*profile.depth)[k]);
  }
  profile.position = make_numbers(std::move(position));
  profile.depth = make_numbers(std::move(depth));
  return profile;
}

/// The cell opposite to the middle of the longest part where none of the profiles, of equal length, is worn.
std::size_t find_middle_of_wear(std::span<const SurfaceProfile> profiles) {
  const std::size_t n = profiles.front().depth->size();
  const auto is_worn = [&](std::size_t cell) {
    return std::ranges::any_of(profiles, [&](const SurfaceProfile& profile) {
      return profile.depth->size() == n && (*profile.depth)[cell % n] > 0.0;
    });
  };
  std::size_t longest = 0;
  std::size_t middle = 0;
  std::size_t length = 0;
  for (std::size_t k = 0; k < 2 * n; ++k) {  // twice around: a part may pass the first cell
    length = is_worn(k) ? 0 : std::min(length + 1, n);
    if (length <= longest) continue;
    longest = length;
    middle = k + n - length / 2;
  }
  return (middle + n / 2) % n;
}

/// About the deepest place of each profile.
void enlarge(Figure& figure, std::span<const SurfaceProfile> profiles) {
  figure.x_begin = std::numeric_limits<double>::infinity();
  figure.x_end = -figure.x_begin;
  for (const SurfaceProfile& profile : profiles) {
    if (!(find_greatest(profile.depth) > 0.0)) continue;
    const double center = (*profile.position)[find_deepest_cell(profile)];
    const double length = profile.position->back() - profile.position->front();
    const double half = profile.radius > 0.0 ? kEnlargedHalfWidth : 0.25 * length;
    figure.x_begin = std::min(figure.x_begin, std::max(profile.position->front(), center - half));
    figure.x_end = std::max(figure.x_end, std::min(profile.position->back(), center + half));
  }
}

}  // namespace

Figure make_depth_figure(std::span<const WornSurfaces> surfaces) {
  Figure figure;
  std::string label;
  std::string unit;
  for (const WornSurfaces& one : surfaces) {
    for (const SurfaceProfile& profile : split_bearing(*one.wear, one.state.total_depth)) {
      if (profile.depth->empty()) continue;
      figure.curves.push_back(make_worn_curve(one, profile, profile.position, profile.depth));
      label = profile.label;
      unit = profile.unit;
    }
  }
  figure.x = make_x_axis(label, unit, figure.curves);
  figure.y = make_y_axis("Wear depth", "m", figure.curves);
  if (unit == "rad") figure.x_end = 2.0 * std::numbers::pi;  // the whole turn, not only from middle to middle
  return figure;
}

Figure make_unrolled_figure(std::span<const WornSurfaces> surfaces, bool of_bearing) {
  Figure figure;
  std::vector<SurfaceProfile> profiles;
  std::vector<const WornSurfaces*> owners;
  for (const WornSurfaces& one : surfaces) {
    for (SurfaceProfile& profile : of_bearing ? split_bearing(*one.wear, one.state.bearing_depth)
                                              : split_journal(*one.wear, one.state.journal_depth)) {
      if (profile.depth->empty()) continue;
      profiles.push_back(std::move(profile));
      owners.push_back(&one);
    }
  }
  if (profiles.empty()) return figure;
  const std::size_t n_last = 1 + static_cast<std::size_t>(std::max(0, profiles.back().part));
  const std::size_t deepest = n_last > 1 ? find_middle_of_wear(profiles) : find_deepest_cell(profiles.back());
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    profiles[k] = cut_opposite(std::move(profiles[k]), deepest);
    figure.curves.push_back(make_worn_curve(*owners[k], profiles[k], profiles[k].position, place_across(profiles[k])));
  }
  const SurfaceProfile& last = profiles.back();
  FigureCurve unworn;
  unworn.name = "unworn";
  unworn.line = LineStyle::dashed;
  unworn.x = last.position;
  unworn.y = make_numbers(std::vector<double>(last.position->size(), 0.0));
  figure.curves.push_back(std::move(unworn));
  figure.x = make_x_axis(last.label, last.unit, figure.curves);
  figure.y =
      make_y_axis(last.radius > 0.0 ? "Radius less unworn radius" : "Depth below the unworn side", "m", figure.curves);
  enlarge(figure, std::span(profiles).last(n_last));
  return figure;
}

Figure make_outline_figure(std::span<const WornSurfaces> surfaces) {
  Figure figure;
  figure.kind = FigureKind::plane;
  double deepest = 0.0;
  double radius = 0.0;
  for (const WornSurfaces& one : surfaces) {
    for (const SurfaceProfile& profile : split_round(one)) {
      deepest = std::max(deepest, find_greatest(profile.depth));
      radius = std::max(radius, profile.radius);
    }
  }
  if (!(deepest > 0.0)) return figure;
  const double factor = find_round_factor(kDepthShown * radius / deepest);
  for (const WornSurfaces& one : surfaces) {
    for (const SurfaceProfile& profile : split_round(one)) {
      figure.curves.push_back(make_outline(one, profile, factor));
      if (profile.name == "journal") figure.curves.back().line = LineStyle::dashed;
    }
  }
  figure.caption = fmt::format(
      "Solid: bearing; dashed: journal, concentric and turned as at zero angle. Depth × {:g}; radii are to scale.",
      factor);
  figure.x = make_x_axis("x in the body", "m", figure.curves);
  figure.y = make_y_axis("y in the body", "m", figure.curves);
  figure.y.display_unit = figure.x.display_unit;
  figure.y.factor = figure.x.factor;
  return figure;
}

}  // namespace gudgeon
