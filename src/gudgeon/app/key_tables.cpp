// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One list of rows, two ways to print it.
#include "gudgeon/app/key_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gudgeon/app/interval_text.h"
#include "gudgeon/base/quantity.h"
#include "gudgeon/model/model_keys.h"
#include "gudgeon/report/table.h"

namespace gudgeon {

namespace {

/// Key, value, unit, range, default, meaning.
using Row = std::array<std::string, 6>;

std::string value_text(const KeyEntry& entry) {
  switch (entry.kind) {
    case ValueKind::quantity:
      return "quantity";
    case ValueKind::vector:
      return "[x, y]";
    case ValueKind::quantities:
      return "array of quantities";
    case ValueKind::count:
      return "whole number";
    case ValueKind::flag:
      return "true or false";
    case ValueKind::text:
      return "text";
    case ValueKind::name:
      return "name of a " + entry.of;
    case ValueKind::choice:
      return fmt::format("\"{}\"", fmt::join(entry.choices, "\", \""));
    case ValueKind::point:
      return "\"body.point\"";
    case ValueKind::point_pair:
      return "[\"body.point\", \"body.point\"]";
    case ValueKind::body_pair:
      return "[\"body\", \"body\"]";
    case ValueKind::function:
      return "function";
    case ValueKind::function_pair:
      return "[x, y], each a function";
    case ValueKind::constants:
      return "{ name = quantity, … }";
    case ValueKind::points:
      return "{ name = [x, y], … }";
    case ValueKind::law:
      return "law of " + entry.of;
    case ValueKind::table:
      return "table";
    case ValueKind::array_of_tables:
      return "array of tables";
    case ValueKind::overrides:
      return "{ path = value, … }";
  }
  return {};
}

bool is_number(ValueKind kind) {
  using enum ValueKind;
  return kind == quantity || kind == vector || kind == function || kind == function_pair || kind == points;
}

std::string default_text(const KeyEntry& entry) {
  if (!entry.unless.empty()) return fmt::format("required unless {}", entry.unless);
  return entry.required ? "required" : entry.default_text;
}

void add_rows(const std::vector<KeyEntry>& keys, const std::string& before, std::vector<Row>& rows) {
  for (const KeyEntry& entry : keys) {
    const bool bounded = entry.range.minimum > -kUnbounded || entry.range.maximum < kUnbounded;
    const bool has_unit = is_number(entry.kind) && !(entry.dimension == dimension::kNone);
    rows.push_back({before + entry.key + (entry.symbol.empty() ? "" : ", " + entry.symbol), value_text(entry),
                    has_unit ? si_unit(entry.dimension) : "", bounded ? interval_text(entry.range) : "",
                    default_text(entry), entry.meaning});
    add_rows(entry.keys, before + entry.key + ".", rows);
  }
}

std::vector<Row> list_rows(const KeyTable& table) {
  std::vector<Row> rows;
  if (!table.type.empty()) {
    rows.push_back({"type", fmt::format("\"{}\"", table.type), "", "",
                    table.type_required ? "required" : "told by its other keys", ""});
  }
  add_rows(table.keys, "", rows);
  return rows;
}

std::string heading_of(const KeyTable& table) {
  if (table.section.empty()) return "Top of the file";
  if (table.section == "curve") return "A curve";
  return table.section == "study" ? "[study]" : fmt::format("[{}.NAME]", table.section);
}

bool has_key(const std::vector<KeyEntry>& keys, std::string_view name) {
  return std::ranges::any_of(keys,
                             [&](const KeyEntry& entry) { return entry.key == name || has_key(entry.keys, name); });
}

void add_names(const std::vector<KeyEntry>& keys, std::vector<std::string>& names) {
  for (const KeyEntry& entry : keys) {
    names.push_back(entry.key);
    add_names(entry.keys, names);
  }
}

}  // namespace

std::string render_keys_page() {
  std::string text =
      "# Keys of a model file\n\nEvery key, made from the tables that the reader itself walks by `gudgeon keys "
      "--markdown`. How values are written and what they do is\nin [The model file](model_file.md). Ranges are "
      "intervals: `(` and `)` leave their end out. Behind a key stands its symbol in formulas, if it has one.\n";
  std::string heading;
  for (const KeyTable& table : list_model_keys()) {
    if (heading_of(table) != heading) text += fmt::format("\n## {}\n", heading_of(table));
    heading = heading_of(table);
    if (!table.type.empty()) text += fmt::format("\n### {}\n", table.type);
    text += fmt::format("\n{}{}.\n\n| key | value | unit | range | default | meaning |\n|---|---|---|---|---|---|\n",
                        static_cast<char>(std::toupper(static_cast<unsigned char>(table.meaning.front()))),
                        table.meaning.substr(1));
    for (const Row& row : list_rows(table)) {
      for (const std::string& cell : row) text += "| " + cell + " ";
      text += "|\n";
    }
  }
  return text;
}

std::string render_keys(std::string_view name) {
  std::string text;
  for (const KeyTable& table : list_model_keys()) {
    const bool whole = name.empty() || table.section == name || table.type == name;
    if (!whole && !has_key(table.keys, name)) continue;
    text += fmt::format("{}{}{}: {}\n", text.empty() ? "" : "\n", heading_of(table),
                        table.type.empty() ? "" : fmt::format(" type = \"{}\"", table.type), table.meaning);
    Table rows({{"key"}, {"value"}, {"unit"}, {"range"}, {"default"}, {"meaning"}});
    for (const Row& row : list_rows(table)) {
      // A key's own name, its symbol left out; those within a table count by their last part.
      const std::string key = row[0].substr(0, row[0].find(','));
      if (whole || key.substr(key.rfind('.') + 1) == name) rows.add_row({row.begin(), row.end()});
    }
    text += rows.render(false);
  }
  return text;
}

std::vector<std::string> list_key_names() {
  std::vector<std::string> names;
  for (const KeyTable& table : list_model_keys()) {
    if (!table.section.empty()) names.push_back(table.section);
    if (!table.type.empty()) names.push_back(table.type);
    add_names(table.keys, names);
  }
  return names;
}

}  // namespace gudgeon
