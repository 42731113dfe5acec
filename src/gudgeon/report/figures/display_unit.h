// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Units that suit the numbers on an axis.
#pragma once

#include <span>
#include <string>

#include "gudgeon/report/figures/figure.h"

namespace gudgeon {

/// An axis whose unit has a prefix that suits values of that magnitude: (0.002, "m") gives mm. Metres and newtons take
/// prefixes, radians become degrees, all other units stay.
FigureAxis make_axis(std::string label, const std::string& unit, double magnitude);

/// The axis for everything the curves show along it.
FigureAxis make_x_axis(std::string label, const std::string& unit, std::span<const FigureCurve> curves);
FigureAxis make_y_axis(std::string label, const std::string& unit, std::span<const FigureCurve> curves);

/// "m/s^2" as it is printed: "m/s²".
std::string print_unit(std::string unit);

/// "torque" as a label begins: "Torque".
std::string capitalize(std::string text);

/// "Wear depth (µm)".
std::string print_axis(const FigureAxis& axis);

}  // namespace gudgeon
