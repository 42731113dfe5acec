// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dimensions in words and in SI units.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "gudgeon/base/quantity.h"

namespace gudgeon {

namespace {

struct NamedDimension {
  Dimension dimension;
  std::string_view name;
  std::string_view unit;
};

constexpr std::array<NamedDimension, 20> kNamed{{
    {dimension::kNone, "a number without unit", "1"},
    {dimension::kLength, "a length", "m"},
    {dimension::kMass, "a mass", "kg"},
    {dimension::kTime, "a time", "s"},
    {dimension::kAngle, "an angle", "rad"},
    {dimension::kInertia, "a moment of inertia", "kg m^2"},
    {dimension::kSpeed, "a speed", "m/s"},
    {dimension::kAngularSpeed, "an angular speed", "rad/s"},
    {dimension::kAcceleration, "an acceleration", "m/s^2"},
    {dimension::kForce, "a force", "N"},
    {dimension::kTorque, "a torque", "N m"},
    {dimension::kPressure, "a pressure", "Pa"},
    {dimension::kPerPressure, "one over a pressure", "1/Pa"},
    {dimension::kPerLength, "one over a length", "1/m"},
    {dimension::kPerTime, "one over a time", "1/s"},
    {dimension::kTimePerLength, "a time over a length", "s/m"},
    {dimension::kStiffness, "a stiffness", "N/m"},
    {dimension::kDamping, "a damping coefficient", "N s/m"},
    {dimension::kAngularStiffness, "an angular stiffness", "N m/rad"},
    {dimension::kAngularDamping, "an angular damping coefficient", "N m s/rad"},
}};

const NamedDimension* find_named(Dimension dimension) {
  const auto* found = std::ranges::find(kNamed, dimension, &NamedDimension::dimension);
  return found == kNamed.end() ? nullptr : found;
}

std::string with_power(std::string_view symbol, int power) {
  return power == 1 ? std::string{symbol} : fmt::format("{}^{}", symbol, power);
}

}  // namespace

std::string si_unit(Dimension dimension) {
  if (const NamedDimension* named = find_named(dimension)) return std::string{named->unit};
  const std::array<std::pair<std::string_view, int>, 4> factors{
      {{"kg", dimension.mass}, {"m", dimension.length}, {"rad", dimension.angle}, {"s", dimension.time}}};
  std::string above;
  std::string below;
  for (const auto& [symbol, power] : factors) {
    if (power > 0) above += fmt::format("{}{}", above.empty() ? "" : " ", with_power(symbol, power));
    if (power < 0) below += fmt::format("/{}", with_power(symbol, -power));
  }
  return fmt::format("{}{}", above.empty() ? "1" : above, below);
}

std::string dimension_name(Dimension dimension) {
  if (const NamedDimension* named = find_named(dimension)) return std::string{named->name};
  return fmt::format("a quantity in {}", si_unit(dimension));
}

}  // namespace gudgeon
