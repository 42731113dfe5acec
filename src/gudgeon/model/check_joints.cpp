// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for joints: what they connect, and the sizes of bearings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/model/check_fields.h"

namespace gudgeon {

namespace {

// A clearance beyond this part of the radius is no bearing fit; contact stiffness and wear assume near-equal radii.
constexpr double kWideClearance = 0.1;

// What the sizes of a joint must be together, where each alone is within its range.

void check_sizes(CheckRules& rules, const RevoluteClearance& joint, const std::string& subject,
                 const std::string& path) {
  using dimension::kLength;
  const CheckRules::Value radius{subject, path + ".bearing_radius", joint.bearing_radius, kLength};
  const CheckRules::Value clearance{subject, path + ".radial_clearance", joint.radial_clearance, kLength};
  if (!(joint.radial_clearance > 0.0 && joint.bearing_radius > 0.0)) return;
  if (joint.radial_clearance >= joint.bearing_radius) {
    rules.diagnostics.error("E-MODEL-013", clearance.path,
                            fmt::format("{}: radial_clearance is {}; it must be below the bearing_radius, {}", subject,
                                        rules.describe(clearance), rules.describe(radius)),
                            {"the journal's radius is bearing_radius - radial_clearance"});
  } else if (joint.radial_clearance > kWideClearance * joint.bearing_radius) {
    rules.diagnostics.remark(
        "R-MODEL-103", clearance.path,
        fmt::format("{}: radial_clearance is {}, {:.0f} % of the bearing_radius; the contact laws "
                    "are meant for radii that nearly agree",
                    subject, rules.describe(clearance), 100.0 * joint.radial_clearance / joint.bearing_radius));
  }
}

void check_sizes(CheckRules& rules, const PrismaticClearance& joint, const std::string& subject,
                 const std::string& path) {
  const auto length = [&](const char* key, double value) {
    return rules.describe({subject, path + "." + key, value, dimension::kLength});
  };
  if (!is_within_ranges(joint)) return;
  if (joint.journal_length >= joint.bearing_length) {
    rules.diagnostics.error(
        "E-MODEL-014", path + ".journal_length",
        fmt::format("{}: journal_length is {}; it must be below the bearing_length, {}", subject,
                    length("journal_length", joint.journal_length), length("bearing_length", joint.bearing_length)),
        {"the slot must be longer than the block that slides in it"});
  }
  const double largest = 0.5 * std::min(joint.journal_length, joint.journal_height);
  if (joint.corner_radius > largest) {
    rules.diagnostics.error("E-MODEL-015", path + ".corner_radius",
                            fmt::format("{}: corner_radius is {}; it must be at most half the block's length and "
                                        "height, {:.6g} m",
                                        subject, length("corner_radius", joint.corner_radius), largest));
    return;
  }
  // A corner touches the side it faces only: the block must not fit into its slot crosswise.
  const double diagonal =
      std::hypot(0.5 * joint.journal_length - joint.corner_radius, 0.5 * joint.journal_height - joint.corner_radius) +
      joint.corner_radius;
  if (diagonal > 0.5 * joint.journal_height + joint.clearance) return;
  rules.diagnostics.error(
      "E-MODEL-017", path + ".clearance",
      fmt::format("{}: clearance is {}; the block could turn over in a slot that wide", subject,
                  length("clearance", joint.clearance)),
      {"a block longer than its slot is wide cannot; what is round in its slot is a pin_in_slot_clearance"});
}

void check_sizes(CheckRules& rules, const PinInSlotClearance& joint, const std::string& subject,
                 const std::string& path) {
  if (!is_within_ranges(joint) || 2.0 * joint.journal_radius < joint.bearing_length) return;
  rules.diagnostics.error(
      "E-MODEL-016", path + ".journal_radius",
      fmt::format("{}: journal_radius is {}; a pin of that size does not fit into a slot of bearing_length {}", subject,
                  rules.describe({subject, path + ".journal_radius", joint.journal_radius, dimension::kLength}),
                  rules.describe({subject, path + ".bearing_length", joint.bearing_length, dimension::kLength})));
}

template <class Kind>
void check_sizes(CheckRules& /*rules*/, const Kind& /*joint*/, const std::string& /*subject*/,
                 const std::string& /*path*/) {}

void check_joint(CheckRules& rules, const Joint& joint) {
  const std::string subject = fmt::format("joint '{}'", joint.name);
  const std::string path = fmt::format("joints.{}", joint.name);
  const bool clearance = has_clearance(joint.kind);
  const auto [first, second] = anchors(joint.kind);
  if (first.body == second.body && !first.body.empty()) {
    rules.diagnostics.error("E-MODEL-023", path + (clearance ? ".journal" : ".between"),
                            fmt::format("{} connects body '{}' with itself", subject, first.body));
  }
  std::visit(
      [&](const auto& kind) {
        FieldCheck(rules, subject, path).check(kind);
        check_sizes(rules, kind, subject, path);
      },
      joint.kind);
  check_joint_friction(rules, joint);
}

}  // namespace

void check_anchor(CheckRules& rules, const std::string& subject, const std::string& path, const Anchor& anchor) {
  const Mechanism& mechanism = rules.mechanism;
  const int index = rules.names.find_body(anchor.body);
  if (index < 0) {
    rules.report_unknown(
        "E-MODEL-021", path,
        fmt::format("{} is on '{}.{}', and no body has the name '{}'", subject, anchor.body, anchor.point, anchor.body),
        anchor.body, "bodies", list_names(mechanism.bodies));
    return;
  }
  const Body& body = mechanism.bodies[index];
  if (rules.names.find_point(index, anchor.point) != nullptr) return;
  rules.report_unknown("E-MODEL-022", path,
                       fmt::format("{} is on '{}.{}', and body '{}' has no point '{}'", subject, anchor.body,
                                   anchor.point, anchor.body, anchor.point),
                       anchor.point, fmt::format("points of '{}'", body.name), list_names(body.points));
}

void check_joints(CheckRules& rules) {
  for (const Joint& joint : rules.mechanism.joints) check_joint(rules, joint);
}

}  // namespace gudgeon
