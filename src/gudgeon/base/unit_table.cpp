// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Looks units up, first as they stand, then as prefix and unit.
#include "gudgeon/base/unit_table.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

constexpr std::array<Unit, 20> kUnits{{
    {"m", dimension::kLength, 1.0, 0, true},
    {"g", dimension::kMass, 1.0, -3, true},
    {"s", dimension::kTime, 1.0, 0, true},
    {"rad", dimension::kAngle, 1.0, 0, true},
    {"N", dimension::kForce, 1.0, 0, true},
    {"Pa", dimension::kPressure, 1.0, 0, true},
    {"J", dimension::kTorque, 1.0, 0, true},
    {"W", {2, 1, -3, 0}, 1.0, 0, true},
    {"Hz", dimension::kPerTime, 1.0, 0, true},
    {"bar", dimension::kPressure, 1.0, 5, true},
    {"deg", dimension::kAngle, std::numbers::pi / 180.0, 0, false},
    {"rev", dimension::kAngle, kTurn, 0, false},
    {"rpm", dimension::kAngularSpeed, kTurn / 60.0, 0, false},
    {"min", dimension::kTime, 60.0, 0, false},
    {"h", dimension::kTime, 3600.0, 0, false},
    {"t", dimension::kMass, 1.0, 3, false},
    {"in", dimension::kLength, 254.0, -4, false},
    {"ft", dimension::kLength, 3048.0, -4, false},
    {"%", dimension::kNone, 1.0, -2, false},
    {"pi", dimension::kNone, std::numbers::pi, 0, false},
}};

struct Prefix {
  char symbol;
  int power_of_ten;
};

// The usual ones come first: among equally near units the first is suggested.
constexpr std::array<Prefix, 8> kPrefixes{
    {{'m', -3}, {'k', 3}, {'M', 6}, {'G', 9}, {'u', -6}, {'c', -2}, {'n', -9}, {'d', -1}}};

// What people write instead, beyond the reach of a spelling distance.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kOtherWords{{
    {"sec", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"meter", "m"},
    {"metre", "m"},
    {"radian", "rad"},
    {"radians", "rad"},
    {"turn", "rev"},
}};

std::vector<std::string> all_symbols() {
  std::vector<std::string> symbols;
  for (const Unit& unit : kUnits) {
    symbols.emplace_back(unit.symbol);
    if (!unit.takes_prefix) continue;
    for (const Prefix& prefix : kPrefixes) symbols.push_back(prefix.symbol + std::string{unit.symbol});
  }
  return symbols;
}

const Unit* find_plain(std::string_view symbol) {
  const auto* found = std::ranges::find(kUnits, symbol, &Unit::symbol);
  return found == kUnits.end() ? nullptr : found;
}

}  // namespace

std::optional<Unit> find_unit(std::string_view symbol) {
  if (symbol.empty()) return std::nullopt;
  if (const Unit* plain = find_plain(symbol)) return *plain;
  const auto* prefix = std::ranges::find(kPrefixes, symbol.front(), &Prefix::symbol);
  const Unit* base = find_plain(symbol.substr(1));
  if (prefix == kPrefixes.end() || base == nullptr || !base->takes_prefix) return std::nullopt;
  Unit unit = *base;
  unit.power_of_ten += prefix->power_of_ten;
  return unit;
}

std::string find_nearest_unit(std::string_view symbol) {
  const auto* other = std::ranges::find(kOtherWords, symbol, &std::pair<std::string_view, std::string_view>::first);
  if (other != kOtherWords.end()) return std::string{other->second};
  // Two units written as one word, "Nm" or "kNmm".
  const auto newton = symbol.find('N');
  if (newton != std::string_view::npos && find_unit(symbol.substr(0, newton + 1)) &&
      find_unit(symbol.substr(newton + 1))) {
    return std::string{symbol.substr(0, newton + 1)} + " " + std::string{symbol.substr(newton + 1)};
  }
  const std::vector<std::string> symbols = all_symbols();
  const std::string* nearest = find_nearest(symbol, symbols);
  return nearest == nullptr ? std::string{} : *nearest;
}

}  // namespace gudgeon
