// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Choosing prefix and digits.
#include "gudgeon/report/number_format.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace gudgeon {

namespace {

constexpr int kDigits = 4;
constexpr int kMostDigits = 6;  // before the point; beyond them a number is told by its power of ten

struct Prefix {
  const char* text;
  int exponent;  ///< of ten
};

constexpr std::array kPrefixes{Prefix{"p", -12}, Prefix{"n", -9}, Prefix{"µ", -6}, Prefix{"m", -3},
                               Prefix{"", 0},    Prefix{"k", 3},  Prefix{"M", 6},  Prefix{"G", 9}};

/// The leading unit of "m/s^2", "N m", "mm^3": what a prefix goes on.
struct LeadingUnit {
  std::string_view symbol;
  int power = 1;
};

LeadingUnit find_leading_unit(std::string_view unit) {
  LeadingUnit leading{unit.substr(0, unit.find_first_of(" /^*")), 1};
  const std::string_view rest = unit.substr(leading.symbol.size());
  if (rest.size() >= 2 && rest[0] == '^' && rest[1] >= '1' && rest[1] <= '9') leading.power = rest[1] - '0';
  return leading;
}

/// Largest exponent a unit is enlarged by, or -1 when it takes no prefix.
int find_largest_exponent(std::string_view symbol) {
  for (const std::string_view full : {"N", "J", "W", "Pa", "Hz"}) {
    if (symbol == full) return kPrefixes.back().exponent;
  }
  return symbol == "m" || symbol == "s" ? 0 : -1;
}

/// Exponent of ten of the first digit after rounding to kDigits: 0 for 1 … 9.9994, 3 for 999.96.
int find_decade(double value) {
  if (value == 0.0 || !std::isfinite(value)) return 0;
  const std::string rounded = fmt::format("{:.{}e}", std::abs(value), kDigits - 1);
  return std::stoi(rounded.substr(rounded.find('e') + 1));
}

Prefix choose_prefix(double value, std::string_view unit) {
  const LeadingUnit leading = find_leading_unit(unit);
  const int largest = find_largest_exponent(leading.symbol);
  Prefix chosen{"", 0};
  if (largest < 0 || value == 0.0) return chosen;
  const int decade = find_decade(value);
  // smaller than the smallest prefix: rounding noise, better told by its power of ten
  if (decade < kPrefixes.front().exponent * leading.power) return chosen;
  // From one prefix to the next a cube grows by nine digits; of these the last three are better behind a point.
  const int behind_point = std::max(0, 3 * leading.power - kMostDigits);
  for (const Prefix& prefix : kPrefixes) {
    if (prefix.exponent <= largest && prefix.exponent * leading.power <= decade + behind_point) chosen = prefix;
  }
  return chosen;
}

}  // namespace

std::string format_number(double value) {
  if (std::isnan(value)) return kNoNumber;
  if (value == 0.0) return "0";
  const int decade = find_decade(value);
  if (!std::isfinite(value) || decade < -4 || decade >= kMostDigits) return fmt::format("{:.{}e}", value, kDigits - 1);
  return fmt::format("{:.{}f}", value, std::max(0, kDigits - 1 - decade));
}

std::string format_engineering(double value, std::string_view unit) {
  if (std::isnan(value)) return kNoNumber;
  const Prefix prefix = choose_prefix(value, unit);
  const int exponent = prefix.exponent * find_leading_unit(unit).power;
  // dividing by a power of ten that is exact keeps 0.03 m at 30.00 mm
  const double scaled = exponent < 0 ? value * std::pow(10.0, -exponent) : value / std::pow(10.0, exponent);
  if (unit.empty() || unit == "1") return format_number(scaled);
  return fmt::format("{} {}{}", format_number(scaled), prefix.text, unit);
}

std::string format_count(std::int64_t count) {
  const std::string digits = fmt::format("{}", count);
  const std::size_t n_sign = count < 0 ? 1 : 0;
  std::string grouped;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > n_sign && (digits.size() - i) % 3 == 0) grouped += ' ';
    grouped += digits[i];
  }
  return grouped;
}

std::string format_degrees(double angle) {
  if (std::isnan(angle)) return kNoNumber;
  return fmt::format("{:.0f}°", angle * 180.0 / std::numbers::pi);
}

}  // namespace gudgeon
