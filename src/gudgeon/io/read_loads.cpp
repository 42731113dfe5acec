// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads of every type.
#include <fmt/format.h>

#include <utility>

#include "gudgeon/base/alternatives.h"
#include "gudgeon/io/field_reader.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

/// A load that its numbers make a simpler one.
AnyLoad simplify(VariableForce load, const TableReader& table) {
  const auto* x = std::get_if<double>(&load.x);
  const auto* y = std::get_if<double>(&load.y);
  if (table.has("axes") || x == nullptr || y == nullptr) return load;
  return ConstantForce{load.point, {*x, *y}};
}

AnyLoad simplify(VariableTorque load, const TableReader& table) {
  const auto* torque = std::get_if<double>(&load.torque);
  if (table.has("against") || torque == nullptr) return load;
  return ConstantTorque{load.body, *torque};
}

AnyLoad simplify(Spring load, TableReader& table) {
  // A damper has no length of its own.
  if (load.stiffness != 0.0) table.find_required("free_length");
  return load;
}

template <class Kind>
AnyLoad simplify(Kind load, const TableReader& /*table*/) {
  return load;
}

/// The type that is named, or that of a load with a point or a body; nothing, reported, where neither tells.
std::optional<std::string> read_type(TableReader& table) {
  if (table.has("type")) return table.find_text("type");
  const bool point = table.has("point");
  const bool body = table.has("body");
  if (point && body) table.report("E-FILE-013", "point", "body and point exclude each other");
  if (!point && !body) table.report("E-FILE-002", "body", "body or point is missing");
  if (point == body) return std::nullopt;
  return point ? "force" : "torque";
}

std::optional<Load> read_load(const DocumentEntry& entry, ReadLog& log) {
  TableReader table{entry.node, "loads." + entry.key, fmt::format("load '{}'", entry.key), log};
  const std::optional<std::string> type = read_type(table);
  std::optional<Load> load;
  std::vector<std::string> types;
  for_each_alternative<AnyLoad>([&]<class Kind>() {
    if constexpr (FileLoad<Kind>) {
      types.emplace_back(Kind::kType);
      if (type != Kind::kType) return;
      Kind kind;
      FieldReader(table).read(kind);
      load = Load{entry.key, simplify(std::move(kind), table)};
    }
  });
  if (load) {
    table.check_unknown_keys();
  } else if (type) {
    table.report_unknown_choice("type", *type, types);
  }
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
