// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers that depend on time and on where the mechanism is: expressions and tables.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gudgeon/base/curve.h"
#include "gudgeon/base/smoothing_spline.h"

namespace gudgeon {

/// A formula in SI units and radians, "-k * (piston.x - 0.2)". It may use the time t, pi, the constants beside it and
/// the channels of find_channel_names(); motions may use the time only.
struct Expression {
  std::string text;
  std::vector<std::pair<std::string, double>> constants;  ///< by name, in SI
};

/// How a curve passes near noisy points instead of through them; one of the two is positive.
struct Smoothing {
  /// Cut-off [1 a unit of the argument]: half is left of a wave of it, next to nothing of faster ones.
  double frequency = 0.0;
  /// Root of the mean square distance from the points, as the values.
  double tolerance = 0.0;
};

/// A curve through points, or near them.
struct SampledCurve {
  std::string over = "t";         ///< the time, or a channel
  std::vector<double> arguments;  ///< in SI, strictly increasing
  std::vector<double> values;     ///< in SI, one an argument; periodic: the last equals the first
  bool periodic = false;          ///< goes on beyond its ends as it was; otherwise the end values are held
  std::optional<Interpolation> interpolation = std::nullopt;  ///< unless given monotone for a load, a motion's a spline
  std::optional<Smoothing> smoothing = std::nullopt;          ///< of a spline; unless given it meets its points
};

/// Unless a curve says how it runs, a load keeps the shape of its points and a motion can be differentiated twice.
inline constexpr Interpolation kLoadInterpolation = Interpolation::monotone;
inline constexpr Interpolation kMotionInterpolation = Interpolation::spline;

/// A curve with smoothing, which the caller has checked, and how far it is from its points.
SmoothedCurve make_smoothed(const SampledCurve& curve);
/// Curves that the caller has checked, ready to be evaluated.
Curve make_load_curve(const SampledCurve& curve);
Curve make_motion_curve(const SampledCurve& curve);

/// A constant, an expression or a curve.
using Function = std::variant<double, Expression, SampledCurve>;

}  // namespace gudgeon
