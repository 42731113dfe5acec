// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One function a kind of value.
#include "gudgeon/io/field_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace gudgeon {

namespace {

/// "crank_1.A" as body and point; nothing, and an error under the path, when it is not of that form.
Anchor read_anchor(const DocumentNode& node, const std::string& path, TableReader& table) {
  const auto* text = std::get_if<std::string>(&node.value);
  const auto dot = text == nullptr ? std::string::npos : text->find('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == text->size()) {
    table.log().diagnostics.error(
        "E-FILE-008", path,
        fmt::format("{}: {} is not a point of a body; write \"body.point\"", table.subject(), node.written));
    return {};
  }
  return {text->substr(0, dot), text->substr(dot + 1)};
}

/// The one of that name; nothing for none, which `report` is told with all names unless nothing was written.
template <class Named, class Report>
Named find_named(std::span<const Named> known, const std::string& name, const Report& report) {
  const auto found = std::ranges::find(known, name, &Named::name);
  if (found != known.end()) return *found;
  std::vector<std::string> names;
  for (const Named& one : known) names.push_back(one.name);
  if (!name.empty()) report(names);
  return {};
}

}  // namespace

void FieldReader::read_value(std::string_view key, const FieldTraits& traits, double& value) {
  value = traits.required ? table_.read_quantity(key, traits.dimension)
                          : table_.find_quantity(key, traits.dimension).value_or(value);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& traits, std::optional<double>& value) {
  value = table_.find_quantity(key, traits.dimension);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& traits, Vec2& value) {
  value = table_.find_vector(key, traits.dimension).value_or(value);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& traits, std::optional<Vec2>& value) {
  value = table_.find_vector(key, traits.dimension);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& /*traits*/, int& value) {
  value = table_.find_count(key).value_or(value);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& /*traits*/, bool& value) {
  value = table_.find_switch(key).value_or(value);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& traits, std::string& value) {
  value = traits.required ? table_.read_text(key) : table_.find_text(key).value_or(value);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& /*traits*/, Anchor& value) {
  if (const DocumentNode* node = table_.find_required(key)) value = read_anchor(*node, table_.path_of(key), table_);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& traits, Function& value) {
  const auto& known = constants();
  const DocumentNode* node = table_.find_required(key);
  if (node != nullptr) value = read_function(*node, table_.path_of(key), traits.dimension, known, table_);
}

void FieldReader::read_value(std::string_view key, const FieldTraits& /*traits*/, Material& value) {
  const std::string name = table_.read_text(key);
  value = find_named(shared_.materials, name, [&](const std::vector<std::string>& names) {
    report_choice("E-FILE-011", table_.path_of(key),
                  fmt::format("{}: {}: unknown material '{}'", table_.subject(), key, name), name, names, table_.log());
  });
}

void FieldReader::read_value(std::string_view key, const FieldTraits& /*traits*/, ContactProperties& value) {
  const std::string name = table_.read_text(key);
  value = find_named(shared_.contacts, name, [&](const std::vector<std::string>& names) {
    report_choice("E-FILE-012", table_.path_of(key), fmt::format("{}: unknown contact '{}'", table_.subject(), name),
                  name, names, table_.log());
  });
}

void FieldReader::read_value(std::string_view key, const FieldTraits& traits, std::vector<Point>& value) {
  auto points = table_.find_table(key, subject_of(key));
  if (!points) return;
  for (const DocumentEntry& entry : points->entries()) {
    // A point that cannot be read is kept, so that the joints on it are not reported as well.
    const auto position = points->read_vector(entry.node, points->path_of(entry.key), traits.dimension);
    value.push_back({entry.key, position.value_or(Vec2{})});
  }
}

void FieldReader::read_value(std::string_view key, const FieldTraits& /*traits*/, std::vector<double>& value) {
  const DocumentNode* node = table_.find_required(key);
  if (node == nullptr) return;
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array == nullptr) {
    table_.report("E-FILE-003", key,
                  fmt::format("{} must be an array of quantities, one per stage; nan where none is known", key));
    return;
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    const std::string path = fmt::format("{}.{}", table_.path_of(key), i);
    const std::string label = fmt::format("{}: value {}", table_.subject(), i + 1);
    value.push_back(read_quantity((*array)[i], std::nullopt, path, label, table_.log()).value_or(0.0));
  }
}

void FieldReader::read_value(std::string_view key, const FieldTraits& /*traits*/, std::vector<ReferenceValue>& value) {
  const DocumentNode* node = table_.find(key);
  if (node == nullptr) return;
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array == nullptr) {
    table_.report("E-FILE-003", key, fmt::format("{} must be an array of tables, [[study.{}]]", key, key));
    return;
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    TableReader one{(*array)[i], fmt::format("{}.{}", table_.path_of(key), i), fmt::format("reference value {}", i + 1),
                    table_.log()};
    FieldReader(one).read(value.emplace_back());
    one.check_unknown_keys();
  }
}

void FieldReader::read_pair(std::string_view key, const FieldTraits& /*traits*/, Anchor& first, Anchor& second) {
  const auto* array = find_pair(key, "an array of two points, [\"body.point\", \"body.point\"]");
  if (array == nullptr) return;
  first = read_anchor((*array)[0], fmt::format("{}.0", table_.path_of(key)), table_);
  second = read_anchor((*array)[1], fmt::format("{}.1", table_.path_of(key)), table_);
}

void FieldReader::read_pair(std::string_view key, const FieldTraits& /*traits*/, std::string& first,
                            std::string& second) {
  static constexpr std::string_view kRule = "an array of two bodies, [\"body\", \"body\"]";
  const auto* array = find_pair(key, kRule);
  if (array == nullptr) return;
  const auto* first_name = std::get_if<std::string>(&(*array)[0].value);
  const auto* second_name = std::get_if<std::string>(&(*array)[1].value);
  if (first_name == nullptr || second_name == nullptr) {
    table_.report("E-FILE-003", key, fmt::format("{} must be {}", key, kRule));
    return;
  }
  first = *first_name;
  second = *second_name;
}

void FieldReader::read_pair(std::string_view key, const FieldTraits& traits, Function& first, Function& second) {
  const auto& known = constants();
  const auto* array = find_pair(key, "an array of two, x and y, each a quantity, a formula or a table of points");
  if (array == nullptr) return;
  const std::string path = table_.path_of(key);
  first = read_function((*array)[0], path + ".0", traits.dimension, known, table_);
  second = read_function((*array)[1], path + ".1", traits.dimension, known, table_);
}

std::string FieldReader::subject_of(std::string_view key) const { return fmt::format("{}: {}", table_.subject(), key); }

const DocumentNode::Array* FieldReader::find_pair(std::string_view key, std::string_view rule) {
  const DocumentNode* node = table_.find_required(key);
  if (node == nullptr) return nullptr;
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array != nullptr && array->size() == 2) return array;
  table_.report("E-FILE-003", key, fmt::format("{} must be {}", key, rule));
  return nullptr;
}

const std::vector<std::pair<std::string, double>>& FieldReader::constants() {
  if (!constants_) constants_ = read_constants(table_);
  return *constants_;
}

}  // namespace gudgeon
