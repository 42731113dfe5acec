// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A smooth curve through given points.
#pragma once

#include <utility>
#include <vector>

namespace gudgeon {

/// The cubic spline through points (x_k, y_k), twice continuously differentiable inside. Ends: "not a knot" (third
/// derivative continuous at the second and the last but one point; with three points a parabola, with two a line), or
/// periodic, where the last value must equal the first. Outside, a periodic spline repeats and another holds its end
/// value, with zero slope and curvature.
class CubicSpline {
 public:
  struct Value {
    double value;
    double slope;
    double curvature;  ///< second derivative
  };

  /// At least two points (three when periodic), arguments strictly increasing: the caller has checked.
  CubicSpline(std::vector<double> arguments, std::vector<double> values, bool periodic);

  [[nodiscard]] Value eval(double argument) const noexcept;
  /// The points between which the argument lies, at or above the first and below the second; infinite beyond the ends.
  [[nodiscard]] std::pair<double, double> find_piece(double argument) const noexcept;

 private:
  std::vector<double> arguments_;
  std::vector<double> values_;
  std::vector<double> curvatures_;  // second derivative at each point
  bool periodic_;
};

}  // namespace gudgeon
