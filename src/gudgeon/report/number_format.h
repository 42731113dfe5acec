// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers for people: four digits and a unit of fitting size.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gudgeon {

/// Stands where there is no number.
inline constexpr const char* kNoNumber = "–";

/// A value in SI with four significant digits and a prefix that suits it: (5.768e-6, "m") gives "5.768 µm",
/// (2072, "N") "2.072 kN", (3e-9, "m^3") "3.000 mm^3", (0.5, "rad") "0.5000 rad". Metres and seconds are not
/// enlarged ("606.1 m/s^2"), units of no prefix (kg, rad, 1) stay. NaN gives a dash.
std::string format_engineering(double value, std::string_view unit);

/// Four significant digits without unit: "0.9412", "12.35", "1.500e-09".
std::string format_number(double value);

/// Digits in groups of three: "12 345 678".
std::string format_count(std::int64_t count);

/// An angle in radians as whole degrees: "128°".
std::string format_degrees(double angle);

}  // namespace gudgeon
