// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Joints of every type.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gudgeon/io/read_joint_friction.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

Anchor read_anchor_of(TableReader& table, std::string_view key) {
  const DocumentNode* node = table.find_required(key);
  return node == nullptr ? Anchor{} : read_anchor(*node, table.path_of(key), table);
}

AnyJoint read_revolute(TableReader& table) {
  Revolute joint;
  read_between(table, joint.first, joint.second);
  joint.friction = read_joint_friction(table, list_friction_sizes(joint));
  return joint;
}

AnyJoint read_prismatic(TableReader& table) {
  Prismatic joint;
  read_between(table, joint.first, joint.second);
  joint.direction = table.read_quantity("direction", dimension::kAngle);
  joint.relative_angle = table.find_quantity("relative_angle", dimension::kAngle).value_or(0.0);
  if (auto start = table.find_table("start", table.subject() + ": start")) {
    joint.start_displacement = start->find_quantity("displacement", dimension::kLength);
    joint.start_speed = start->find_quantity("speed", dimension::kSpeed);
    start->check_unknown_keys();
  }
  joint.friction = read_joint_friction(table, list_friction_sizes(joint));
  return joint;
}

AnyJoint read_rigid(TableReader& table) {
  Rigid joint;
  read_between(table, joint.first, joint.second);
  joint.relative_angle = table.find_quantity("relative_angle", dimension::kAngle).value_or(0.0);
  return joint;
}

ContactProperties read_contact_of(TableReader& table, std::span<const ContactProperties> contacts) {
  const std::string name = table.read_text("contact");
  const auto found = std::ranges::find(contacts, name, &ContactProperties::name);
  if (found != contacts.end()) return *found;
  std::vector<std::string> names;
  for (const ContactProperties& contact : contacts) names.push_back(contact.name);
  if (!name.empty()) {
    report_choice("E-FILE-012", table.path_of("contact"),
                  fmt::format("{}: unknown contact '{}'", table.subject(), name), name, names, table.log());
  }
  return {};
}

/// What every clearance joint has: its two points, its width and its contact.
template <ClearanceJoint Kind>
Kind read_clearance(TableReader& table, std::span<const ContactProperties> contacts) {
  Kind joint;
  joint.bearing = read_anchor_of(table, "bearing");
  joint.journal = read_anchor_of(table, "journal");
  joint.width = table.read_quantity("width", dimension::kLength);
  joint.contact = read_contact_of(table, contacts);
  return joint;
}

AnyJoint read_revolute_clearance(TableReader& table, std::span<const ContactProperties> contacts) {
  auto joint = read_clearance<RevoluteClearance>(table, contacts);
  joint.bearing_radius = table.read_quantity("bearing_radius", dimension::kLength);
  joint.radial_clearance = table.read_quantity("radial_clearance", dimension::kLength);
  return joint;
}

AnyJoint read_prismatic_clearance(TableReader& table, std::span<const ContactProperties> contacts) {
  auto joint = read_clearance<PrismaticClearance>(table, contacts);
  joint.direction = table.read_quantity("direction", dimension::kAngle);
  joint.relative_angle = table.find_quantity("relative_angle", dimension::kAngle).value_or(0.0);
  joint.bearing_length = table.read_quantity("bearing_length", dimension::kLength);
  joint.journal_length = table.read_quantity("journal_length", dimension::kLength);
  joint.journal_height = table.read_quantity("journal_height", dimension::kLength);
  joint.corner_radius = table.read_quantity("corner_radius", dimension::kLength);
  joint.clearance = table.read_quantity("clearance", dimension::kLength);
  return joint;
}

AnyJoint read_pin_in_slot_clearance(TableReader& table, std::span<const ContactProperties> contacts) {
  auto joint = read_clearance<PinInSlotClearance>(table, contacts);
  joint.direction = table.read_quantity("direction", dimension::kAngle);
  joint.bearing_length = table.read_quantity("bearing_length", dimension::kLength);
  joint.journal_radius = table.read_quantity("journal_radius", dimension::kLength);
  joint.clearance = table.read_quantity("clearance", dimension::kLength);
  return joint;
}

AnyJoint read_pin_in_slot(TableReader& table) {
  PinInSlot joint;
  read_between(table, joint.first, joint.second);
  joint.direction = table.read_quantity("direction", dimension::kAngle);
  joint.friction = read_joint_friction(table, list_friction_sizes(joint));
  return joint;
}

std::optional<Branch> read_branch(TableReader& table) {
  if (!table.has("branch")) return std::nullopt;
  Branch branch = Branch::left;
  table.update_choice<Branch>("branch", kBranches, branch);
  return branch;
}

std::optional<AnyJoint> read_kind(TableReader& table, std::span<const ContactProperties> contacts) {
  const std::string type = table.read_text("type");
  if (type == "revolute") return read_revolute(table);
  if (type == "prismatic") return read_prismatic(table);
  if (type == "rigid") return read_rigid(table);
  if (type == "pin_in_slot") return read_pin_in_slot(table);
  if (type == "revolute_clearance") return read_revolute_clearance(table, contacts);
  if (type == "prismatic_clearance") return read_prismatic_clearance(table, contacts);
  if (type == "pin_in_slot_clearance") return read_pin_in_slot_clearance(table, contacts);
  const std::vector<std::string> types{"revolute",           "prismatic",           "pin_in_slot",          "rigid",
                                       "revolute_clearance", "prismatic_clearance", "pin_in_slot_clearance"};
  if (!type.empty()) table.report_unknown_choice("type", type, types);
  return std::nullopt;
}

}  // namespace

void read_between(TableReader& table, Anchor& first, Anchor& second) {
  const DocumentNode* node = table.find_required("between");
  if (node == nullptr) return;
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array == nullptr || array->size() != 2) {
    table.report("E-FILE-003", "between", "between must be an array of two points, [\"body.point\", \"body.point\"]");
    return;
  }
  first = read_anchor((*array)[0], table.path_of("between.0"), table);
  second = read_anchor((*array)[1], table.path_of("between.1"), table);
}

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

std::vector<Joint> read_joints(TableReader& root, std::span<const ContactProperties> contacts) {
  std::vector<Joint> joints;
  auto all = root.find_table("joints", "joints");
  if (!all) return joints;
  for (const DocumentEntry& entry : all->entries()) {
    TableReader table{entry.node, "joints." + entry.key, fmt::format("joint '{}'", entry.key), root.log()};
    const std::optional<AnyJoint> kind = read_kind(table, contacts);
    if (!kind) continue;  // which keys are right depends on the type
    const std::optional<Branch> branch = read_branch(table);
    table.check_unknown_keys();
    joints.push_back({entry.key, *kind, branch});
  }
  return joints;
}

}  // namespace gudgeon
