// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a curve does between its points: where it leaves the range of its neighbours, and where it would run otherwise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/model/channel_names.h"
#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

// Places tried between two points: a summit between two of them is missed by a 1000th of its height.
constexpr int kPlacesBetween = 16;
// Below this share of the curve's range nobody would see it in a picture.
constexpr double kSeen = 0.01;

double find_range(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  return high - low;
}

/// Calls visit(k, argument) for places between the points k and k + 1, for every k.
template <class Visit>
void visit_between(const std::vector<double>& arguments, Visit visit) {
  for (std::size_t k = 0; k + 1 < arguments.size(); ++k) {
    for (int i = 1; i < kPlacesBetween; ++i) {
      visit(k, arguments[k] + (arguments[k + 1] - arguments[k]) * i / kPlacesBetween);
    }
  }
}

std::string describe_argument(const SampledCurve& curve, double argument) {
  return fmt::format("{} = {}", curve.over,
                     with_unit(argument, find_channel_dimension(curve.over).value_or(dimension::kNone)));
}

/// A load's curve of which nothing is said would run quite otherwise as a spline.
void warn_of_choice(CheckRules& rules, const FunctionUse& use, const SampledCurve& points) {
  const Curve curve = make_load_curve(points);
  const Curve spline(points.arguments, points.values, points.periodic, Interpolation::spline);
  double apart = 0.0;
  double place = 0.0;
  visit_between(points.arguments, [&](std::size_t, double argument) {
    const double here = std::abs(spline.eval(argument).value - curve.eval(argument).value);
    if (here > apart) place = argument;
    apart = std::max(apart, here);
  });
  if (!(apart > kSeen * find_range(points.values))) return;
  rules.diagnostics.warning(
      "W-MODEL-115", use.path(),
      fmt::format("{}: the curve keeps the shape of its points; a smooth spline through them would differ by up to {}, "
                  "at {}",
                  use.subject, with_unit(apart, use.dimension), describe_argument(points, place)),
      {"say which is meant: interpolation = \"linear\", \"monotone\" (as now) or \"spline\""});
}

void remark_overshoot(CheckRules& rules, const FunctionUse& use, const SampledCurve& points, const Curve& curve) {
  double beyond = 0.0;
  double place = 0.0;
  std::size_t piece = 0;
  std::vector<bool> leaves(points.arguments.size());
  const double noticed = kSeen * find_range(points.values);
  visit_between(points.arguments, [&](std::size_t k, double argument) {
    const auto [low, high] = std::minmax(points.values[k], points.values[k + 1]);
    const double value = curve.eval(argument).value;
    const double here = std::max(value - high, low - value);
    leaves[k] = leaves[k] || here > noticed;
    if (here <= beyond) return;
    beyond = here;
    place = argument;
    piece = k;
  });
  const auto count = std::ranges::count(leaves, true);
  if (count == 0) return;
  const std::string least = with_unit(std::min(points.values[piece], points.values[piece + 1]), use.dimension);
  const std::string most = with_unit(std::max(points.values[piece], points.values[piece + 1]), use.dimension);
  rules.diagnostics.remark(
      "R-MODEL-116", use.path(),
      fmt::format("{}: between points {} and {} the spline leaves their range, {} to {}, by {}: it is {} at {}{}",
                  use.subject, piece + 1, piece + 2, least, most, with_unit(beyond, use.dimension),
                  with_unit(curve.eval(place).value, use.dimension), describe_argument(points, place),
                  count > 1 ? fmt::format("; likewise in {} more places", count - 1) : ""),
      {use.of_time_only ? "more points where the motion bends hold it; gudgeon check --plots draws it"
                        : "interpolation = \"monotone\" or \"linear\" stays between its points; gudgeon check --plots "
                          "draws it"});
}

}  // namespace

void remark_curve(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  if (curve.smoothing) return;
  if (!use.of_time_only && !curve.interpolation) warn_of_choice(rules, use, curve);
  const Interpolation fallback = use.of_time_only ? kMotionInterpolation : kLoadInterpolation;
  if (curve.interpolation.value_or(fallback) != Interpolation::spline) return;
  remark_overshoot(rules, use, curve, make_motion_curve(curve));
}

}  // namespace gudgeon
