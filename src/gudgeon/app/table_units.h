// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The units of tables for people, and numbers in them.
#pragma once

#include <numbers>
#include <string>

namespace gudgeon {

inline constexpr double kDegree = std::numbers::pi / 180.0;
inline constexpr double kMillimeter = 1e-3;

/// A value to `digits` decimals without a minus before zero.
std::string render_fixed(double value, int digits);

}  // namespace gudgeon
