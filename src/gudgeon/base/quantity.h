// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Quantities with units, as they are written in a model file: "0.5 mm", "200 GPa", "-1 rev/s".
// Inside the program every value is in SI and radians; units exist only at the border.
#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace gudgeon {

/// Exponents of metre, kilogram, second and radian. The angle is counted, so that "rad/s" is not "1/s".
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;

  friend constexpr bool operator==(Dimension, Dimension) = default;
};

/// Of one over a quantity.
constexpr Dimension find_inverse(Dimension d) { return {-d.length, -d.mass, -d.time, -d.angle}; }

namespace dimension {
inline constexpr Dimension kNone{};
inline constexpr Dimension kLength{1, 0, 0, 0};
inline constexpr Dimension kMass{0, 1, 0, 0};
inline constexpr Dimension kTime{0, 0, 1, 0};
inline constexpr Dimension kAngle{0, 0, 0, 1};
inline constexpr Dimension kInertia{2, 1, 0, 0};
inline constexpr Dimension kSpeed{1, 0, -1, 0};
inline constexpr Dimension kAngularSpeed{0, 0, -1, 1};
inline constexpr Dimension kAcceleration{1, 0, -2, 0};
inline constexpr Dimension kForce{1, 1, -2, 0};
inline constexpr Dimension kTorque{2, 1, -2, 0};
inline constexpr Dimension kPressure{-1, 1, -2, 0};
inline constexpr Dimension kPerPressure{1, -1, 2, 0};
inline constexpr Dimension kPerLength{-1, 0, 0, 0};
inline constexpr Dimension kPerTime{0, 0, -1, 0};
inline constexpr Dimension kTimePerLength{-1, 0, 1, 0};
inline constexpr Dimension kStiffness{0, 1, -2, 0};
inline constexpr Dimension kDamping{0, 1, -1, 0};
inline constexpr Dimension kAngularStiffness{2, 1, -2, -1};
inline constexpr Dimension kAngularDamping{2, 1, -1, -1};
}  // namespace dimension

struct Quantity {
  double value = 0.0;  ///< in SI units and radians
  Dimension dimension;
};

/// Why a text is not a quantity; the message names the offending part and the nearest known unit.
struct QuantityError {
  std::string message;
};

/// Reads "0.5 mm", "8e-14 1/Pa", "0.2382e-3 kg m^2", "-1 rev/s", "60.28 deg", "12" …
/// A number, then factors separated by blanks, '*' or '/', each a unit with an optional SI prefix and a power.
std::variant<Quantity, QuantityError> parse_quantity(std::string_view text);

/// The SI unit of a dimension in text, "N m", "m/s^2", "rad/s"; "1" for none.
std::string si_unit(Dimension dimension);

/// What a dimension is called in a message: "a length", "a torque", "a pressure" …
std::string dimension_name(Dimension dimension);

}  // namespace gudgeon
