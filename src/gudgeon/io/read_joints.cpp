// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Joints of every type.
#include <fmt/format.h>

#include "gudgeon/io/field_reader.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

std::optional<AnyJoint> read_kind(TableReader& table, const SharedTables& shared) {
  const std::optional<std::string> type = table.read_name("type");
  std::optional<AnyJoint> joint;
  std::vector<std::string> types;
  for_each_alternative<AnyJoint>([&]<class Kind>() {
    types.emplace_back(Kind::kType);
    if (type != Kind::kType) return;
    Kind kind;
    FieldReader(table, shared).read(kind);
    joint = std::move(kind);
  });
  if (!joint && type) table.report_unknown_choice("type", *type, types);
  return joint;
}

}  // namespace

std::vector<Joint> read_joints(TableReader& root, std::span<const ContactProperties> contacts) {
  std::vector<Joint> joints;
  auto all = root.find_table("joints", "joints");
  if (!all) return joints;
  for (const DocumentEntry& entry : all->entries()) {
    TableReader table{entry.node, "joints." + entry.key, fmt::format("joint '{}'", entry.key), root.log()};
    std::optional<AnyJoint> kind = read_kind(table, {.contacts = contacts});
    if (!kind) continue;  // which keys are right depends on the type
    Joint joint{entry.key, *std::move(kind)};
    FieldReader(table).read(joint);
    table.check_unknown_keys();
    joints.push_back(std::move(joint));
  }
  return joints;
}

}  // namespace gudgeon
