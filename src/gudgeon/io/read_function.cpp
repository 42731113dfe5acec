// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a node is: a constant, a formula or a curve.
#include "gudgeon/io/read_function.h"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "gudgeon/model/channel_names.h"

namespace gudgeon {

namespace {

constexpr double kUnread = std::numeric_limits<double>::quiet_NaN();
// For a constant that could not be read: its error is told, and formulas may use its name.
constexpr double kStandIn = 1.0;

/// "force.0" of the path "loads.push.force.0" is "x of force".
std::string name_value(const std::string& path) {
  const auto dot = path.rfind('.');
  const std::string last = path.substr(dot + 1);
  if (last != "0" && last != "1") return last;
  const std::string rest = path.substr(0, dot);
  return fmt::format("{} of {}", last == "0" ? "x" : "y", rest.substr(rest.rfind('.') + 1));
}

/// A text that reads as a quantity is one; where an operator could also join names, its dimension must be right too:
/// "2*t" is twice the time, not two tonnes.
bool is_quantity(const std::string& text, Dimension dimension) {
  const auto parsed = parse_quantity(text);
  const auto* quantity = std::get_if<Quantity>(&parsed);
  if (quantity == nullptr) return false;
  return quantity->dimension == dimension || text.find_first_of("*/^") == std::string::npos;
}

/// One unit in words, "mm", as what a number times it is in SI.
double read_unit(TableReader& table, std::string_view key, std::optional<Dimension> dimension) {
  const DocumentNode* node = table.find(key);
  if (node == nullptr) return 1.0;
  const auto* text = std::get_if<std::string>(&node->value);
  const auto parsed = text == nullptr ? std::variant<Quantity, QuantityError>{QuantityError{"expected a string"}}
                                      : parse_quantity("1 " + *text);
  if (const auto* error = std::get_if<QuantityError>(&parsed)) {
    table.report("E-FILE-004", key, fmt::format("{} is not a valid unit: {}", key, error->message));
    return 1.0;
  }
  const Quantity& unit = std::get<Quantity>(parsed);
  if (dimension && unit.dimension != *dimension) {
    table.report("E-FILE-005", key,
                 fmt::format("{} is \"{}\", {}; expected {}", key, *text, dimension_name(unit.dimension),
                             dimension_name(*dimension)));
    return 1.0;
  }
  return unit.value;
}

/// Bare numbers in the unit, and quantities in their own.
std::vector<double> read_numbers(TableReader& table, std::string_view key, double unit,
                                 std::optional<Dimension> dimension) {
  std::vector<double> numbers;
  const DocumentNode* node = table.find_required(key);
  if (node == nullptr) return numbers;
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array == nullptr) {
    table.report("E-FILE-003", key, fmt::format("{} must be an array of numbers or quantities", key));
    return numbers;
  }
  for (std::size_t k = 0; k < array->size(); ++k) {
    const DocumentNode& entry = (*array)[k];
    const bool bare = std::holds_alternative<double>(entry.value);
    const auto number =
        read_quantity(entry, dimension, fmt::format("{}.{}", table.path_of(key), k),
                      fmt::format("{}: entry {} of {}", table.subject(), k + 1, key), table.log(), Smallness::any);
    numbers.push_back(number.value_or(kUnread) * (bare ? unit : 1.0));
  }
  return numbers;
}

/// The dimension tells a cut-off from a tolerance.
std::optional<Smoothing> read_smoothing(TableReader& table, std::optional<Dimension> argument, Dimension value) {
  const DocumentNode* node = table.find("smoothing");
  if (node == nullptr) return std::nullopt;
  const auto* text = std::get_if<std::string>(&node->value);
  const auto parsed =
      text == nullptr ? std::variant<Quantity, QuantityError>{QuantityError{"it needs a unit"}} : parse_quantity(*text);
  if (const auto* error = std::get_if<QuantityError>(&parsed)) {
    table.report("E-FILE-004", "smoothing", fmt::format("smoothing cannot be read: {}", error->message),
                 {"smoothing = \"20 Hz\", a cut-off frequency, or the noise of the values, \"0.05 deg\""});
    return std::nullopt;
  }
  const Quantity& quantity = std::get<Quantity>(parsed);
  const Dimension per_argument = find_inverse(argument.value_or(dimension::kTime));
  if (quantity.dimension == per_argument) return Smoothing{quantity.value, 0.0};
  if (quantity.dimension == value) return Smoothing{0.0, quantity.value};
  table.report("E-FILE-005", "smoothing",
               fmt::format("smoothing is \"{}\", {}; expected a cut-off in {} or a tolerance, {}", *text,
                           dimension_name(quantity.dimension), si_unit(per_argument), dimension_name(value)));
  return std::nullopt;
}

SampledCurve read_curve(TableReader& table, Dimension dimension) {
  SampledCurve curve;
  curve.over = table.find_text("over").value_or("t");
  const std::optional<Dimension> argument = find_channel_dimension(curve.over);
  curve.arguments = read_numbers(table, "arguments", read_unit(table, "argument_unit", argument), argument);
  curve.values = read_numbers(table, "values", read_unit(table, "value_unit", dimension), dimension);
  curve.periodic = table.find_switch("periodic").value_or(false);
  if (table.has("interpolation")) {
    curve.interpolation = kLoadInterpolation;
    table.update_choice<Interpolation>("interpolation", kInterpolations, *curve.interpolation);
  }
  curve.smoothing = read_smoothing(table, argument, dimension);
  table.check_unknown_keys();
  return curve;
}

}  // namespace

std::vector<std::pair<std::string, double>> read_constants(TableReader& owner) {
  std::vector<std::pair<std::string, double>> constants;
  auto table = owner.find_table("constants", owner.subject() + ": constants");
  if (!table) return constants;
  for (const DocumentEntry& entry : table->entries()) {
    const auto value = read_quantity(entry.node, std::nullopt, table->path_of(entry.key),
                                     fmt::format("{}: constant '{}'", owner.subject(), entry.key), owner.log());
    constants.emplace_back(entry.key, value.value_or(kStandIn));
  }
  return constants;
}

Function read_function(const DocumentNode& node, const std::string& path, Dimension dimension,
                       const std::vector<std::pair<std::string, double>>& constants, TableReader& owner) {
  const std::string label = fmt::format("{}: {}", owner.subject(), name_value(path));
  if (node.table() != nullptr) {
    TableReader table{node, path, label, owner.log()};
    return read_curve(table, dimension);
  }
  const auto* text = std::get_if<std::string>(&node.value);
  if (text != nullptr && !is_quantity(*text, dimension)) return Expression{*text, constants};
  return read_quantity(node, dimension, path, label, owner.log()).value_or(kUnread);
}

}  // namespace gudgeon
