// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads quantities with units. Numbers are read by std::from_chars, so no locale can change them.
#include "gudgeon/base/quantity.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "gudgeon/base/unit_table.h"

namespace gudgeon {

namespace {

// Characters of typeset text, as the plain ones that the grammar knows; "⁻" before the digits it belongs to.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kTypeset{{
    {"⁻¹", "^-1"},
    {"⁻²", "^-2"},
    {"⁻³", "^-3"},
    {"²", "^2"},
    {"³", "^3"},
    {"·", "*"},
    {"µ", "u"},
    {"μ", "u"},
    {"°", "deg"},
    {"−", "-"},
    {"π", "pi"},
    {"×", "*"},
}};

// A power beyond this is a slip of the pen.
constexpr int kGreatestPower = 9;

std::string plain_text(std::string_view text) {
  std::string plain{text};
  for (const auto& [typeset, replacement] : kTypeset) {
    for (auto at = plain.find(typeset); at != std::string::npos; at = plain.find(typeset, at)) {
      plain.replace(at, typeset.size(), replacement);
    }
  }
  return plain;
}

double scale_by_ten(double value, int power) {
  double scale = 1.0;
  for (int i = 0; i < std::abs(power); ++i) scale *= 10.0;
  return power < 0 ? value / scale : value * scale;
}

/// number * factor * 10^power_of_ten in the dimension.
struct Product {
  double number = 1.0;
  double factor = 1.0;
  int power_of_ten = 0;
  Dimension dimension;

  void multiply(const Unit& unit, int power) {
    dimension.length += power * unit.dimension.length;
    dimension.mass += power * unit.dimension.mass;
    dimension.time += power * unit.dimension.time;
    dimension.angle += power * unit.dimension.angle;
    power_of_ten += power * unit.power_of_ten;
    for (int i = 0; i < std::abs(power); ++i) factor = power < 0 ? factor / unit.factor : factor * unit.factor;
  }
  [[nodiscard]] double value() const { return scale_by_ten(number * factor, power_of_ten); }
};

class QuantityParser {
 public:
  explicit QuantityParser(std::string_view text) : rest_(text) {}

  std::variant<Quantity, QuantityError> parse() {
    bool good = parse_leading_number();
    while (good && (skip_blanks(), !rest_.empty())) good = parse_factor();
    if (!good) return QuantityError{error_};
    const double value = product_.value();
    if (!std::isfinite(value)) return QuantityError{"the value is too large"};
    if (value == 0.0 && product_.number != 0.0) return QuantityError{"the value is too small"};
    return Quantity{value, product_.dimension};
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r\n";

  bool fail(std::string message) {
    error_ = std::move(message);
    return false;
  }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size())); }

  bool take(char expected) {
    if (rest_.empty() || rest_.front() != expected) return false;
    rest_.remove_prefix(1);
    return true;
  }

  [[nodiscard]] bool number_ahead() const {
    const std::size_t first = rest_.starts_with('.') ? 1 : 0;
    return rest_.size() > first && rest_[first] >= '0' && rest_[first] <= '9';
  }

  bool parse_leading_number() {
    skip_blanks();
    if (rest_.empty()) return fail("it is empty; a number was expected");
    const bool negative = take('-');
    if (!negative) take('+');
    if (rest_.starts_with("pi") && (rest_.size() == 2 || kBlanksAndSigns.find(rest_[2]) != std::string_view::npos)) {
      return parse_unit(1) && (product_.number = negative ? -1.0 : 1.0, true);
    }
    if (!number_ahead()) return fail(fmt::format("it must begin with a finite number, not with '{}'", rest_));
    const std::optional<double> number = parse_number();
    if (!number) return false;
    product_.number = negative ? -*number : *number;
    return true;
  }

  std::optional<double> parse_number() {
    double number = 0.0;
    const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    const std::string_view read = rest_.substr(0, static_cast<std::size_t>(end - rest_.data()));
    if (code != std::errc{}) {
      fail(fmt::format("number '{}' is out of the range of a double", read));
      return std::nullopt;
    }
    rest_.remove_prefix(read.size());
    return number;
  }

  bool parse_factor() {
    const bool divided = take('/');
    const bool multiplied = !divided && take('*');
    skip_blanks();
    if (rest_.empty()) return fail(fmt::format("a unit is missing after '{}'", divided ? '/' : '*'));
    if (number_ahead()) return parse_number_factor(divided, multiplied);
    return parse_unit(divided ? -1 : 1);
  }

  // A number inside: "8e-14 1/Pa", "pi/2 rad", "2*3 mm"; after a mere blank only a 1 makes sense.
  bool parse_number_factor(bool divided, bool multiplied) {
    const std::string_view all = rest_;
    const std::optional<double> number = parse_number();
    if (!number) return false;
    if (!divided && !multiplied && *number != 1.0) return fail(fmt::format("'{}' is not a unit", all));
    if (divided && *number == 0.0) return fail("it divides by zero");
    product_.number = divided ? product_.number / *number : product_.number * *number;
    return true;
  }

  bool parse_unit(int sign) {
    const std::string_view symbol = rest_.substr(0, rest_.find_first_of(" \t\r\n*/^"));
    if (symbol.empty()) return fail(fmt::format("a unit was expected at '{}'", rest_));
    rest_.remove_prefix(symbol.size());
    const std::optional<Unit> unit = find_unit(symbol);
    if (!unit) {
      const std::string nearest = find_nearest_unit(symbol);
      return fail(nearest.empty() ? fmt::format("unknown unit '{}'", symbol)
                                  : fmt::format("unknown unit '{}'; did you mean '{}'?", symbol, nearest));
    }
    int power = 1;
    if (take('^') && !parse_power(symbol, power)) return false;
    product_.multiply(*unit, sign * power);
    return true;
  }

  bool parse_power(std::string_view symbol, int& power) {
    const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), power);
    const bool fraction = end != rest_.data() + rest_.size() && (*end == '.');
    if (code != std::errc{} || fraction || power > kGreatestPower || power < -kGreatestPower) {
      return fail(fmt::format("the power of '{}' must be a whole number from -{} to {}, as in '{}^2'", symbol,
                              kGreatestPower, kGreatestPower, symbol));
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return true;
  }

  static constexpr std::string_view kBlanksAndSigns = " \t\r\n*/^";

  std::string_view rest_;
  Product product_;
  std::string error_;
};

}  // namespace

std::variant<Quantity, QuantityError> parse_quantity(std::string_view text) {
  const std::string plain = plain_text(text);
  return QuantityParser{plain}.parse();
}

}  // namespace gudgeon
