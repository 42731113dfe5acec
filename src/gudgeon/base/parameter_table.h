// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One table of a law's parameters, from which reader, writer, checks and manual are made.
#pragma once

#include <limits>
#include <string_view>

#include "gudgeon/base/quantity.h"

namespace gudgeon {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// A parameter's permitted values; an open end does not belong to them.
struct ParameterRange {
  double minimum = -kUnbounded;
  double maximum = kUnbounded;
  bool open_minimum = false;
  bool open_maximum = false;

  [[nodiscard]] constexpr bool contains(double value) const {
    const bool above = open_minimum ? value > minimum : value >= minimum;
    const bool below = open_maximum ? value < maximum : value <= maximum;
    return above && below;  // false for NaN
  }
};

inline constexpr ParameterRange kPositive{0.0, kUnbounded, true, true};
inline constexpr ParameterRange kNotNegative{0.0, kUnbounded, false, true};

/// A default of kRequired means that the model file must give the value.
inline constexpr double kRequired = std::numeric_limits<double>::quiet_NaN();

/// One parameter of a law: its key in the model file, its symbol in the formula, and where it is stored.
/// Its default is the value of a default-constructed Law; NaN means that it must be given.
template <class Law>
struct Parameter {
  std::string_view key;
  std::string_view symbol;
  Dimension dimension;
  ParameterRange range;
  std::string_view meaning;
  double Law::*member;
};

}  // namespace gudgeon
