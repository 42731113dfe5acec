// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads of every type.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "gudgeon/io/read_function.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

const std::vector<std::string> kTypes{"force", "torque", "spring", "torsion_spring", "bushing"};

bool is_constant(const Function& function) { return std::holds_alternative<double>(function); }

/// Two functions in an array.
std::pair<Function, Function> read_force(TableReader& table) {
  const auto constants = read_constants(table);
  const DocumentNode* node = table.find_required("force");
  if (node == nullptr) return {};
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array == nullptr || array->size() != 2) {
    table.report("E-FILE-003", "force",
                 "force must be an array of two, x and y, each a force, a formula or a table of points");
    return {};
  }
  const std::string path = table.path_of("force");
  return {read_function((*array)[0], path + ".0", dimension::kForce, constants, table),
          read_function((*array)[1], path + ".1", dimension::kForce, constants, table)};
}

AnyLoad read_force_load(TableReader& table) {
  const DocumentNode* point = table.find_required("point");
  const Anchor anchor = point == nullptr ? Anchor{} : read_anchor(*point, table.path_of("point"), table);
  const auto axes = table.find_text("axes");
  auto [x, y] = read_force(table);
  if (!axes && is_constant(x) && is_constant(y)) {
    return ConstantForce{anchor, {std::get<double>(x), std::get<double>(y)}};
  }
  return VariableForce{anchor, std::move(x), std::move(y), axes.value_or(kFrameName)};
}

AnyLoad read_torque_load(TableReader& table) {
  const std::string body = table.read_text("body");
  const auto against = table.find_text("against");
  const auto constants = read_constants(table);
  const DocumentNode* node = table.find_required("torque");
  Function torque = node == nullptr
                        ? Function{0.0}
                        : read_function(*node, table.path_of("torque"), dimension::kTorque, constants, table);
  if (!against && is_constant(torque)) return ConstantTorque{body, std::get<double>(torque)};
  return VariableTorque{body, against.value_or(kFrameName), std::move(torque)};
}

double find_or_zero(TableReader& table, std::string_view key, Dimension dimension) {
  return table.find_quantity(key, dimension).value_or(0.0);
}

AnyLoad read_spring(TableReader& table) {
  Spring spring;
  read_between(table, spring.first, spring.second);
  spring.stiffness = find_or_zero(table, "stiffness", dimension::kStiffness);
  spring.damping = find_or_zero(table, "damping", dimension::kDamping);
  // A damper has no length of its own.
  spring.free_length = spring.stiffness != 0.0 ? table.read_quantity("free_length", dimension::kLength)
                                               : find_or_zero(table, "free_length", dimension::kLength);
  return spring;
}

AnyLoad read_torsion_spring(TableReader& table) {
  TorsionSpring spring;
  if (const DocumentNode* node = table.find_required("between")) {
    const auto* array = std::get_if<DocumentNode::Array>(&node->value);
    const bool pair = array != nullptr && array->size() == 2;
    const auto* first = pair ? std::get_if<std::string>(&(*array)[0].value) : nullptr;
    const auto* second = pair ? std::get_if<std::string>(&(*array)[1].value) : nullptr;
    if (first != nullptr && second != nullptr) {
      spring.first = *first;
      spring.second = *second;
    } else {
      table.report("E-FILE-003", "between", "between must be an array of two bodies, [\"body\", \"body\"]");
    }
  }
  spring.stiffness = find_or_zero(table, "stiffness", dimension::kAngularStiffness);
  spring.damping = find_or_zero(table, "damping", dimension::kAngularDamping);
  spring.free_angle = find_or_zero(table, "free_angle", dimension::kAngle);
  return spring;
}

AnyLoad read_bushing(TableReader& table) {
  Bushing bushing;
  read_between(table, bushing.first, bushing.second);
  bushing.stiffness = table.find_vector("stiffness", dimension::kStiffness).value_or(Vec2{});
  bushing.damping = table.find_vector("damping", dimension::kDamping).value_or(Vec2{});
  bushing.angular_stiffness = find_or_zero(table, "angular_stiffness", dimension::kAngularStiffness);
  bushing.angular_damping = find_or_zero(table, "angular_damping", dimension::kAngularDamping);
  bushing.free_angle = find_or_zero(table, "free_angle", dimension::kAngle);
  return bushing;
}

/// The type that is named, or that of a load with a point or a body.
std::string read_type(TableReader& table) {
  if (const auto type = table.find_text("type")) return *type;
  const bool point = table.has("point");
  const bool body = table.has("body");
  if (point && body) table.report("E-FILE-013", "point", "body and point exclude each other");
  if (!point && !body) table.report("E-FILE-002", "body", "body or point is missing");
  if (point == body) return {};
  return point ? "force" : "torque";
}

std::optional<Load> read_load(const DocumentEntry& entry, ReadLog& log) {
  TableReader table{entry.node, "loads." + entry.key, fmt::format("load '{}'", entry.key), log};
  const std::string type = read_type(table);
  Load load{entry.key, {}};
  if (type == "force") {
    load.kind = read_force_load(table);
  } else if (type == "torque") {
    load.kind = read_torque_load(table);
  } else if (type == "spring") {
    load.kind = read_spring(table);
  } else if (type == "torsion_spring") {
    load.kind = read_torsion_spring(table);
  } else if (type == "bushing") {
    load.kind = read_bushing(table);
  } else {
    if (!type.empty()) table.report_unknown_choice("type", type, kTypes);
    return std::nullopt;
  }
  table.check_unknown_keys();
  return load;
}

}  // namespace

std::vector<Load> read_loads(TableReader& root) {
  std::vector<Load> loads;
  auto all = root.find_table("loads", "loads");
  if (!all) return loads;
  for (const DocumentEntry& entry : all->entries()) {
    if (auto load = read_load(entry, root.log())) loads.push_back(std::move(*load));
  }
  return loads;
}

}  // namespace gudgeon
