// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers that depend on time and on where the mechanism is: expressions and tables.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gudgeon {

/// A formula in SI units and radians, "-k * (piston.x - 0.2)". It may use the time t, pi, the constants beside it and
/// the channels of find_channel_names(); motions may use the time only.
struct Expression {
  std::string text;
  std::vector<std::pair<std::string, double>> constants;  ///< by name, in SI
};

/// A smooth curve through points: a cubic spline, twice continuously differentiable.
struct SampledCurve {
  std::string over = "t";         ///< the time, or a channel
  std::vector<double> arguments;  ///< in SI, strictly increasing
  std::vector<double> values;     ///< in SI, one an argument; periodic: the last equals the first
  bool periodic = false;          ///< goes on beyond its ends as it was; otherwise the end values are held
};

/// A constant, an expression or a curve.
using Function = std::variant<double, Expression, SampledCurve>;

}  // namespace gudgeon
