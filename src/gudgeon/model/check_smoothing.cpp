// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for curves that pass near their points, and the noise of motions that pass through them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/model/channel_names.h"
#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

// Waves over the whole length below which nothing but a parabola is left.
constexpr double kFewestWaves = 0.1;
// Fewer points are a table that somebody wrote, not a measurement.
constexpr int kFewestMeasured = 32;
// Points farther than this share of their range from a gently smoothed curve are not noisy but far apart.
constexpr double kLargestNoise = 0.01;
// Noise makes the acceleration when without it less than one part in this is left. A motion whose waves have ten points
// or more keeps 0.98 of its own.
constexpr double kNotedRatio = 2.0;
// Of white noise sampled Δx apart a curve smoothed at f leaves 1 − (7π/9) f Δx, as mean square, between points and
// curve: the mean of (1 − 1/(1 + (ν/f)⁶))² over all frequencies ν that the points tell.
constexpr double kFollowed = 7.0 * std::numbers::pi / 9.0;
// The distance of points from a curve may grow by this before more than noise has been smoothed away.
constexpr double kSameDistance = 1.02;

double find_range(const SampledCurve& curve) {
  const auto [low, high] = std::ranges::minmax(curve.values);
  return high - low;
}

struct Bend {
  double largest = 0.0;  // magnitude of the second derivative at the points
  double mean = 0.0;     // root of its mean square
};

Bend find_bend(const Curve& curve, const std::vector<double>& arguments) {
  Bend bend;
  for (const double argument : arguments) {
    const double curvature = std::abs(curve.eval(argument).curvature);
    bend.largest = std::max(bend.largest, curvature);
    bend.mean += curvature * curvature;
  }
  bend.mean = std::sqrt(bend.mean / static_cast<double>(arguments.size()));
  return bend;
}

/// The smoothest curve that is no farther from its points than noise alone takes them; from a gently smoothed one down.
SmoothedCurve smooth_noise_away(const MeasuredPoints& points, SmoothedCurve gentle) {
  const auto left = [&](double frequency) { return 1.0 - kFollowed * frequency * points.spacing(); };
  const double variance = gentle.distance * gentle.distance / left(gentle.frequency);
  SmoothedCurve best = std::move(gentle);
  while (best.frequency * points.length() > 1.0) {
    SmoothedCurve smoother = smooth_at(points, best.frequency / std::sqrt(2.0));
    if (smoother.distance > kSameDistance * std::sqrt(variance * left(smoother.frequency))) break;
    best = std::move(smoother);
  }
  return best;
}

void warn_of_noise(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  const MeasuredPoints points{curve.arguments, curve.values, curve.periodic};
  if (static_cast<int>(curve.arguments.size()) < kFewestMeasured) return;
  SmoothedCurve gentle = smooth_at(points, 0.25 * points.highest_frequency());
  if (gentle.distance > kLargestNoise * find_range(curve)) return;
  const Bend rough = find_bend(make_motion_curve(curve), curve.arguments);
  if (!(rough.mean > kNotedRatio * find_bend(gentle.curve, curve.arguments).mean)) return;
  const SmoothedCurve calm = smooth_noise_away(points, std::move(gentle));
  const double left = find_bend(calm.curve, curve.arguments).largest;
  const Dimension acceleration{use.dimension.length, 0, -2, use.dimension.angle};
  rules.diagnostics.warning(
      "W-MODEL-117", use.path(),
      fmt::format(
          "{}: noise in its points, {:.2g} {} from a smooth curve, makes the acceleration: {:.3g} {}, {:.3g} times "
          "the {:.3g} {} that are left without it",
          use.subject, calm.distance, si_unit(use.dimension), rough.largest, si_unit(acceleration),
          rough.largest / left, left, si_unit(acceleration)),
      {fmt::format("smoothing = \"{:.2g} Hz\" passes near the points instead of through them", 1.05 * calm.frequency)});
}

void report_smoothing(CheckRules& rules, const FunctionUse& use, const std::string& what, const std::string& next) {
  rules.diagnostics.error("E-MODEL-091", use.path() + ".smoothing", fmt::format("{}: {}", use.subject, what), {next});
}

bool check_cut_off(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  const MeasuredPoints points{curve.arguments, curve.values, curve.periodic};
  const double lowest = kFewestWaves / points.length();
  const double highest = points.highest_frequency();
  const double asked = curve.smoothing->frequency;
  if (asked >= lowest && asked <= highest) return true;
  const Dimension unit = find_inverse(find_channel_dimension(curve.over).value_or(dimension::kTime));
  report_smoothing(
      rules, use,
      fmt::format("a cut-off of {} leaves nothing or everything of its {} points; it must be {} to {}",
                  with_unit(asked, unit), curve.arguments.size(), with_unit(lowest, unit), with_unit(highest, unit)),
      "choose it above what the mechanism does and below the noise");
  return false;
}

bool check_tolerance(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  const double asked = curve.smoothing->tolerance;
  if (!(asked > 0.0) || !std::isfinite(asked)) {
    report_smoothing(rules, use, fmt::format("smoothing is {}; it must be positive", with_unit(asked, use.dimension)),
                     "a tolerance is the noise of the values, such as a third of the encoder's count");
    return false;
  }
  const SmoothedCurve found = make_smoothed(curve);
  if (found.distance <= asked) return true;
  report_smoothing(rules, use,
                   fmt::format("no smooth curve is as near as {} to its points; the nearest is {} from them",
                               with_unit(asked, use.dimension), with_unit(found.distance, use.dimension)),
                   "take a larger tolerance, or leave smoothing out and the curve passes through its points");
  return false;
}

}  // namespace

bool check_smoothing(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  if (!curve.smoothing) {
    if (use.of_time_only) warn_of_noise(rules, use, curve);
    return true;
  }
  if (curve.interpolation.value_or(Interpolation::spline) != Interpolation::spline) {
    report_smoothing(rules, use, "smoothing makes a spline, and interpolation asks for another curve",
                     "leave one of the two out");
    return false;
  }
  if (curve.arguments.size() < 4) {
    report_smoothing(rules, use, fmt::format("{} points leave nothing to smooth", curve.arguments.size()),
                     "leave smoothing out");
    return false;
  }
  const bool cut_off = curve.smoothing->frequency != 0.0;
  return cut_off ? check_cut_off(rules, use, curve) : check_tolerance(rules, use, curve);
}

}  // namespace gudgeon
