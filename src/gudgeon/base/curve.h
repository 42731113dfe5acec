// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Curves through given points.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace gudgeon {

/// How a curve runs between its points.
enum class Interpolation {
  linear,    ///< straight lines
  monotone,  ///< smooth, and between two points never beyond their values
  spline,    ///< twice continuously differentiable; it may overshoot
};

inline constexpr std::array<std::pair<std::string_view, Interpolation>, 3> kInterpolations{
    {{"linear", Interpolation::linear}, {"monotone", Interpolation::monotone}, {"spline", Interpolation::spline}}};
constexpr std::span<const std::pair<std::string_view, Interpolation>> choices(Interpolation /*kind*/) {
  return kInterpolations;
}

/// A curve through points (x_k, y_k), a cubic between two of them. Outside, a periodic curve, whose last value must
/// equal its first, repeats; another holds its end value, with zero slope and curvature. Ends of a spline that is not
/// periodic: "not a knot" (third derivative continuous at the second and the last but one point; with three points a
/// parabola, with two a line).
class Curve {
 public:
  struct Value {
    double value;
    double slope;
    double curvature;  ///< second derivative
  };

  /// At least two points (three when periodic), arguments strictly increasing: the caller has checked.
  Curve(std::vector<double> arguments, const std::vector<double>& values, bool periodic, Interpolation interpolation);

  /// The spline with those second derivatives at the points; the caller knows that they belong to it.
  Curve(std::vector<double> arguments, const std::vector<double>& values, const std::vector<double>& curvatures,
        bool periodic);

  [[nodiscard]] Value eval(double argument) const noexcept;

  /// Where the cubic that holds the argument begins and ends, in any period; at a point the one above it. Infinite
  /// beyond the ends.
  [[nodiscard]] std::pair<double, double> find_piece(double argument) const noexcept;
  [[nodiscard]] bool is_periodic() const { return periodic_; }
  [[nodiscard]] double period() const { return arguments_.back() - arguments_.front(); }

 private:
  // Between two points with b from 0 to 1 and a = 1 − b: y = a y₀ + b y₁ + a b (a p − b q).
  struct Cubic {
    double first;      // y₀
    double last;       // y₁
    double departure;  // p = h y′ − (y₁ − y₀) at the first point
    double arrival;    // q, the same at the last
  };

  void add_cubics(const std::vector<double>& values, const std::vector<double>& shape);

  std::vector<double> arguments_;
  std::vector<Cubic> cubics_;
  bool periodic_;
  Interpolation interpolation_;
};

}  // namespace gudgeon
