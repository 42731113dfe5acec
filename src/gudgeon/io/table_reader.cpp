// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads and judges single values; every message names the subject, the key and the value as written.
#include "gudgeon/io/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gudgeon {

namespace {

// Counts beyond this are a slip of the pen and would not fit an int.
constexpr double kGreatestCount = 1e9;

// Within these bounds three values times one another, an energy or the square of a length times a stiffness, are still
// numbers and not zero; nothing in nature is beyond them.
constexpr double kGreatestSize = 1e100;
constexpr double kLeastSize = 1e-100;

std::string last_part(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string describe_dimension(Dimension dimension) {
  return dimension == dimension::kNone ? "a number without unit"
                                       : fmt::format("{} ({})", dimension_name(dimension), si_unit(dimension));
}

}  // namespace

std::optional<double> read_quantity(const DocumentNode& node, std::optional<Dimension> dimension,
                                    const std::string& path, const std::string& label, ReadLog& log,
                                    Smallness smallness) {
  const std::string wanted = dimension ? describe_dimension(*dimension) : "a quantity";
  const auto fail = [&](const char* code, const std::string& what, std::vector<std::string> notes = {}) {
    log.diagnostics.error(code, path, fmt::format("{} is {}", label, what), std::move(notes));
    return std::nullopt;
  };
  const auto check_size = [&](double value) -> std::optional<double> {
    const double size = std::abs(value);
    const bool tiny = size > 0.0 && size < kLeastSize && smallness == Smallness::bounded;
    if (!tiny && !(size > kGreatestSize && std::isfinite(value))) return value;
    return fail(
        "E-FILE-016",
        fmt::format("{}, {:g} in SI; values are 0 or from {:g} to {:g} in size, so that their squares and products "
                    "are numbers",
                    node.written, value, kLeastSize, kGreatestSize),
        {"check the exponent and the unit"});
  };
  if (const auto* number = std::get_if<double>(&node.value)) {
    if (!dimension || std::isfinite(*number)) return check_size(*number);
    return fail("E-FILE-004", fmt::format("{}; it must be finite", node.written));
  }
  const auto* text = std::get_if<std::string>(&node.value);
  if (text == nullptr) return fail("E-FILE-003", fmt::format("{}; expected {}", kind_name(node), wanted));
  const auto parsed = parse_quantity(*text);
  if (const auto* wrong = std::get_if<QuantityError>(&parsed)) {
    return fail("E-FILE-004", fmt::format("\"{}\": {}", *text, wrong->message), {"expected " + wanted});
  }
  const auto& quantity = std::get<Quantity>(parsed);
  // "pi/2" is an angle: the radian is a number.
  const bool plain_angle = dimension == dimension::kAngle && quantity.dimension == dimension::kNone;
  if (!dimension || quantity.dimension == *dimension || plain_angle) return check_size(quantity.value);
  return fail("E-FILE-005", fmt::format("\"{}\", {}; expected {}", *text, dimension_name(quantity.dimension), wanted));
}

void report_choice(std::string_view code, const std::string& path, const std::string& message, std::string_view name,
                   std::span<const std::string> possible, ReadLog& log) {
  std::string note =
      possible.empty() ? std::string{"there are none"} : fmt::format("possible: {}", join_names(possible));
  const std::string suggestion = suggest(name, possible);
  if (!suggestion.empty()) note += "   " + suggestion;
  log.diagnostics.error(std::string{code}, path, message, {note});
}

TableReader::TableReader(const DocumentNode& node, std::string path, std::string subject, ReadLog& log)
    : node_(&node), path_(std::move(path)), subject_(std::move(subject)), log_(&log) {
  if (node.table() == nullptr) {
    log.diagnostics.error("E-FILE-003", path_, fmt::format("{} is {}; expected a table", subject_, kind_name(node)));
  }
}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string{key} : fmt::format("{}.{}", path_, key);
}

const DocumentNode::Table& TableReader::entries() const {
  static const DocumentNode::Table kEmpty;
  return node_->table() == nullptr ? kEmpty : *node_->table();
}

bool TableReader::has(std::string_view key) const { return find_node(entries(), key) != nullptr; }

const DocumentNode* TableReader::find(std::string_view key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
  return find_node(entries(), key);
}

const DocumentNode* TableReader::find_required(std::string_view key) {
  const DocumentNode* node = find(key);
  // What is no table has been reported already.
  if (node == nullptr && node_->table() != nullptr) report("E-FILE-002", key, fmt::format("{} is missing", key));
  return node;
}

std::optional<std::string> TableReader::find_text(std::string_view key) {
  const DocumentNode* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* text = std::get_if<std::string>(&node->value)) return *text;
  report("E-FILE-003", key, fmt::format("{} is {}; expected a string", key, kind_name(*node)));
  return std::nullopt;
}

std::string TableReader::read_text(std::string_view key) {
  return find_required(key) == nullptr ? std::string{} : find_text(key).value_or("");
}

std::optional<std::string> TableReader::read_name(std::string_view key) {
  return find_required(key) == nullptr ? std::nullopt : find_text(key);
}

std::optional<double> TableReader::find_quantity(std::string_view key, Dimension dimension) {
  const DocumentNode* node = find(key);
  if (node == nullptr) return std::nullopt;
  return gudgeon::read_quantity(*node, dimension, path_of(key), fmt::format("{}: {}", subject_, key), *log_);
}

double TableReader::read_quantity(std::string_view key, Dimension dimension) {
  constexpr double kUnread = std::numeric_limits<double>::quiet_NaN();
  return find_required(key) == nullptr ? kUnread : find_quantity(key, dimension).value_or(kUnread);
}

std::optional<Vec2> TableReader::find_vector(std::string_view key, Dimension dimension) {
  const DocumentNode* node = find(key);
  if (node == nullptr) return std::nullopt;
  return read_vector(*node, path_of(key), dimension);
}

std::optional<Vec2> TableReader::read_vector(const DocumentNode& node, const std::string& path, Dimension dimension) {
  const auto* array = std::get_if<DocumentNode::Array>(&node.value);
  if (array == nullptr || array->size() != 2) {
    log_->diagnostics.error("E-FILE-003", path,
                            fmt::format("{}: {} must be an array of two quantities, x and y, each {}", subject_,
                                        last_part(path), describe_dimension(dimension)));
    return std::nullopt;
  }
  const std::string label = fmt::format("{}: {}", subject_, last_part(path));
  const auto x = gudgeon::read_quantity((*array)[0], dimension, path + ".0", label + ": x", *log_);
  const auto y = gudgeon::read_quantity((*array)[1], dimension, path + ".1", label + ": y", *log_);
  if (!x || !y) return std::nullopt;
  return Vec2{*x, *y};
}

std::optional<int> TableReader::find_count(std::string_view key) {
  const DocumentNode* node = find(key);
  if (node == nullptr) return std::nullopt;
  const auto* number = std::get_if<double>(&node->value);
  if (number != nullptr && std::abs(*number) <= kGreatestCount && *number == std::trunc(*number)) {
    return static_cast<int>(*number);
  }
  const bool whole = number != nullptr && *number == std::trunc(*number);  // infinity, too
  report("E-FILE-007", key,
         fmt::format("{} is {}; {}", key, node->written,
                     whole ? fmt::format("whole numbers go from {:.0f} to {:.0f} here", -kGreatestCount, kGreatestCount)
                           : "expected a whole number"));
  return std::nullopt;
}

std::optional<bool> TableReader::find_switch(std::string_view key) {
  const DocumentNode* node = find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* value = std::get_if<bool>(&node->value)) return *value;
  report("E-FILE-003", key, fmt::format("{} is {}; expected true or false", key, kind_name(*node)));
  return std::nullopt;
}

std::optional<TableReader> TableReader::find_table(std::string_view key, std::string subject) {
  const DocumentNode* node = find(key);
  if (node == nullptr) return std::nullopt;
  return TableReader{*node, path_of(key), std::move(subject), *log_};
}

bool TableReader::is_newer(std::string_view key, std::string_view than) const {
  // Overrides are made in order, the command line's last.
  const auto rank = [](const DocumentNode& node) {
    if (node.origin.empty()) return 0;
    return node.origin.starts_with("--set") ? 2 : 1;
  };
  const DocumentNode* first = find_node(entries(), key);
  const DocumentNode* second = find_node(entries(), than);
  return first != nullptr && second != nullptr && rank(*first) > rank(*second);
}

void TableReader::report_unknown_choice(std::string_view key, std::string_view name,
                                        std::span<const std::string> possible) {
  report_choice("E-FILE-006", path_of(key), fmt::format("{}: unknown {} '{}'", subject_, key, name), name, possible,
                *log_);
}

void TableReader::report(std::string_view code, std::string_view key, std::string_view message,
                         std::vector<std::string> notes) {
  log_->diagnostics.error(std::string{code}, path_of(key), fmt::format("{}: {}", subject_, message), std::move(notes));
}

void TableReader::check_unknown_keys() {
  for (const DocumentEntry& entry : entries()) {
    if (std::ranges::find(known_, entry.key) != known_.end()) continue;
    // The key is what is wrong, so the caret goes under it.
    if (entry.key_span.line > 0) log_->source.spans[path_of(entry.key)] = entry.key_span;
    report_choice("E-FILE-001", path_of(entry.key), fmt::format("{} has no key '{}'", subject_, entry.key), entry.key,
                  known_, *log_);
  }
}

}  // namespace gudgeon
