// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A smooth curve near measured points: penalised least squares.
#pragma once

#include <span>

#include "gudgeon/base/curve.h"

namespace gudgeon {

/// Points that a curve is to pass near. At least three, arguments strictly increasing.
struct MeasuredPoints {
  std::span<const double> arguments;
  std::span<const double> values;
  bool periodic = false;  ///< the last value equals the first

  [[nodiscard]] double length() const { return arguments.back() - arguments.front(); }
  /// Mean distance of neighbouring arguments.
  [[nodiscard]] double spacing() const { return length() / static_cast<double>(arguments.size() - 1); }
  /// Waves a unit of the argument that points so far apart can still tell: half of one a spacing.
  [[nodiscard]] double highest_frequency() const { return 0.5 / spacing(); }
};

struct SmoothedCurve {
  Curve curve;
  double frequency = 0.0;  ///< cut-off f [1 a unit of the argument]
  double distance = 0.0;   ///< root of the mean square distance of the points
};

/// The spline s with the smallest ∫ (y − s)² + ∫ s‴² / (2π f)⁶: of a wave of frequency ν it leaves 1/(1 + (ν/f)⁶), half
/// at the cut-off f, as a Butterworth filter of third order does that is run forwards and back. Parabolas pass
/// unchanged, so that a steady acceleration is kept up to both ends.
SmoothedCurve smooth_at(const MeasuredPoints& points, double frequency);

/// The smoothest such curve whose distance from the points is no more than the tolerance; where even the highest
/// cut-off that the points can tell is farther from them, that one.
SmoothedCurve smooth_within(const MeasuredPoints& points, double tolerance);

}  // namespace gudgeon
