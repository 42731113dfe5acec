// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Key by key, law by law.
#include "gudgeon/app/model_schema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "gudgeon/base/alternatives.h"
#include "gudgeon/io/old_keys.h"
#include "gudgeon/laws/damping/any.h"
#include "gudgeon/laws/friction/any.h"
#include "gudgeon/laws/normal/any.h"
#include "gudgeon/laws/wear/any.h"
#include "gudgeon/model/body.h"
#include "gudgeon/model/model_keys.h"

namespace gudgeon {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNamePattern = "^[A-Za-z0-9_]+$";
constexpr const char* kPointPattern = "^[^.]+\\.[^.]+$";

Json reference_to(const std::string& definition) { return {{"$ref", "#/definitions/" + definition}}; }

/// Two of the same.
Json pair_of(const Json& item) { return {{"type", "array"}, {"items", item}, {"minItems", 2}, {"maxItems", 2}}; }

/// Values of one kind by name.
Json named(const Json& value) {
  return {{"type", "object"}, {"propertyNames", {{"pattern", kNamePattern}}}, {"additionalProperties", value}};
}

/// A number in SI within the range, or a text with a unit, which nothing here knows the value of.
Json quantity(const ParameterRange& range) {
  Json schema{{"type", {"number", "string"}}};
  if (range.minimum > -kUnbounded) schema[range.open_minimum ? "exclusiveMinimum" : "minimum"] = range.minimum;
  if (range.maximum < kUnbounded) schema[range.open_maximum ? "exclusiveMaximum" : "maximum"] = range.maximum;
  return schema;
}

Json function() { return {{"anyOf", {quantity({}), reference_to("curve")}}}; }

Json table_of(const std::vector<KeyEntry>& keys);
Json law_of(std::string_view family, const std::vector<KeyEntry>& more);

Json value_of(const KeyEntry& entry) {
  switch (entry.kind) {
    case ValueKind::quantity:
      return quantity(entry.range);
    case ValueKind::vector:
      return pair_of(quantity(entry.range));
    case ValueKind::quantities:
      return {{"type", "array"}, {"items", quantity({})}};
    case ValueKind::count: {
      Json schema = quantity(entry.range);
      schema["type"] = "integer";
      return schema;
    }
    case ValueKind::flag:
      return {{"type", "boolean"}};
    case ValueKind::text:
    case ValueKind::name:
      return {{"type", "string"}};
    case ValueKind::choice:
      return {{"enum", entry.choices}};
    case ValueKind::point:
      return {{"type", "string"}, {"pattern", kPointPattern}};
    case ValueKind::point_pair:
      return pair_of({{"type", "string"}, {"pattern", kPointPattern}});
    case ValueKind::body_pair:
      return pair_of({{"type", "string"}});
    case ValueKind::function:
      return function();
    case ValueKind::function_pair:
      return pair_of(function());
    case ValueKind::constants:
      return named(quantity({}));
    case ValueKind::points:
      return named(pair_of(quantity({})));
    case ValueKind::law:
      return entry.keys.empty() ? reference_to(entry.of) : law_of(entry.of, entry.keys);
    case ValueKind::table:
      return table_of(entry.keys);
    case ValueKind::array_of_tables:
      return {{"type", "array"}, {"items", table_of(entry.keys)}};
    case ValueKind::overrides:
      return {{"type", "object"}};
  }
  return {};
}

std::string describe(const KeyEntry& entry) {
  std::string text = entry.meaning;
  if (!(entry.dimension == dimension::kNone)) text += fmt::format(" [{}]", si_unit(entry.dimension));
  if (!entry.required && !entry.default_text.empty()) text += fmt::format("; default: {}", entry.default_text);
  return text;
}

Json property_of(const KeyEntry& entry) {
  Json schema = value_of(entry);
  // What stands beside a reference is not read.
  if (schema.contains("$ref")) schema = {{"allOf", Json::array({schema})}};
  schema["description"] = describe(entry);
  if (entry.default_number) schema["default"] = *entry.default_number;
  return schema;
}

void add_keys(const std::vector<KeyEntry>& keys, Json& schema) {
  for (const KeyEntry& entry : keys) {
    schema["properties"][entry.key] = property_of(entry);
    if (!entry.required) continue;
    if (entry.unless.empty()) {
      schema["required"].push_back(entry.key);
    } else {
      schema["oneOf"] = {{{"required", {entry.key}}}, {{"required", {entry.unless}}}};
    }
  }
}

Json empty_table() {
  return {
      {"type", "object"}, {"properties", Json::object()}, {"required", Json::array()}, {"additionalProperties", false}};
}

Json table_of(const std::vector<KeyEntry>& keys) {
  Json schema = empty_table();
  add_keys(keys, schema);
  return schema;
}

Json table_of(const KeyTable& table) {
  Json schema = empty_table();
  schema["description"] = table.meaning;
  if (!table.type.empty()) schema["properties"]["type"] = {{"const", table.type}};
  if (table.type_required) schema["required"].push_back("type");
  add_keys(table.keys, schema);
  return schema;
}

/// Whether a table is that one of several: by the key that names it, or where there is none or it may be left out by
/// the first key that it must have.
Json is_meant(const Json& table, const std::string& key) {
  const Json has_first{{"required", {table["required"].front()}}};
  if (!table["properties"].contains(key)) return has_first;
  const Json is_named{{"properties", {{key, table["properties"][key]}}}, {"required", {key}}};
  if (table["required"].front() == key) return is_named;
  return {{"anyOf", {is_named, {{"not", {{"required", {key}}}}, {"required", has_first["required"]}}}}};
}

/// One of several tables, told apart by a key. Editors offer the keys of all, and say what is wrong with the one that
/// is meant: of a plain "oneOf" they could only say that none fits.
Json one_of(const Json& tables, const std::string& key) {
  Json schema{{"type", "object"}, {"properties", Json::object()}};
  Json names = Json::array();
  Json any = Json::array();
  for (const Json& table : tables) {
    for (const auto& [name, property] : table["properties"].items()) {
      if (schema["properties"].contains(name)) continue;
      schema["properties"][name] = {{"description", property.value("description", "")}};
    }
    if (table["properties"].contains(key)) names.push_back(table["properties"][key]["const"]);
    any.push_back(is_meant(table, key));
    schema["allOf"].push_back({{"if", any.back()}, {"then", table}});
  }
  if (!names.empty()) schema["properties"][key] = {{"enum", names}, {"description", "says which other keys there are"}};
  schema["anyOf"] = std::move(any);
  return schema;
}

/// A law of a family by its name, with the keys that the caller reads from the same table.
template <class Any>
Json law_of(const std::vector<KeyEntry>& more) {
  Json laws = Json::array();
  for_each_alternative<Any>([&]<class Law>() {
    Json schema = empty_table();
    schema["description"] = Law::kFormula;
    schema["properties"]["law"] = {{"const", Law::kName}};
    schema["required"].push_back("law");
    const Law defaults;
    for (const Parameter<Law>& parameter : Law::kParameters) {
      const std::string key{parameter.key};
      Json& property = schema["properties"][key] = quantity(parameter.range);
      property["description"] =
          fmt::format("{}, {} [{}]", parameter.symbol, parameter.meaning, si_unit(parameter.dimension));
      const double value = defaults.*parameter.member;
      if (std::isnan(value)) {
        schema["required"].push_back(key);
      } else {
        property["default"] = value;
      }
    }
    if constexpr (NestsDamping<Law>) schema["properties"]["damping"] = reference_to("damping");
    add_keys(more, schema);
    laws.push_back(std::move(schema));
  });
  return one_of(laws, "law");
}

Json law_of(std::string_view family, const std::vector<KeyEntry>& more) {
  if (family == "normal_force") return law_of<AnyNormalForce>(more);
  if (family == "damping") return law_of<AnyDamping>(more);
  return family == "friction" ? law_of<AnyFriction>(more) : law_of<AnyWear>(more);
}

Json definitions(const std::vector<KeyTable>& tables) {
  Json all;
  for (const char* family : {"normal_force", "damping", "friction", "wear"}) all[family] = law_of(family, {});
  for (const KeyTable& table : tables) {
    if (table.section == "curve") all["curve"] = table_of(table);
  }
  return all;
}

/// Old names of keys, which the reader accepts for good.
void add_old_keys(std::string_view section, Json& schema) {
  for (const OldKey& old : list_old_keys()) {
    if (old.table != section) continue;
    Json property = schema["properties"].at(std::string(old.key));
    property["deprecated"] = true;
    property["description"] = fmt::format("old name of {}", old.key);
    schema["properties"][std::string(old.old_key)] = std::move(property);
  }
}

/// All tables of a section whose tables have names: one of its types.
Json section_of(std::string_view section, const std::vector<KeyTable>& tables) {
  Json types = Json::array();
  for (const KeyTable& table : tables) {
    if (table.section == section) types.push_back(table_of(table));
  }
  Json schema = named(types.size() == 1 ? types.front() : one_of(types, "type"));
  if (section == "cases") schema.erase("propertyNames");  // they may have any
  if (section == "bodies") {
    Json frame = types.front();
    Json points = frame["properties"]["points"];
    frame["properties"] = {{"points", points}};
    frame["required"] = Json::array();
    frame["description"] = "the body that stands still";
    schema["properties"][kFrameName] = std::move(frame);
  }
  return schema;
}

}  // namespace

std::string render_model_schema() {
  const std::vector<KeyTable> tables = list_model_keys();
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "gudgeon model file"}};
  schema.update(table_of(tables.front()));
  for (const KeyTable& table : tables) {
    Json& properties = schema["properties"];
    if (table.section.empty() || table.section == "curve" || properties.contains(table.section)) continue;
    if (table.section == "study") {
      properties["study"] = table_of(table);
      add_old_keys("study", properties["study"]);
    } else {
      properties[table.section] = section_of(table.section, tables);
    }
  }
  schema["definitions"] = definitions(tables);
  return schema.dump(2) + "\n";
}

}  // namespace gudgeon
