// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for joints: what they connect, and the sizes of bearings.
#include <fmt/format.h>

#include <cmath>

#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

// A clearance beyond this part of the radius is no bearing fit; contact stiffness and wear assume near-equal radii.
constexpr double kWideClearance = 0.1;

void check_angle(CheckRules& rules, const std::string& subject, const std::string& path, double angle) {
  rules.check_range("E-MODEL-005", {subject, path, angle, dimension::kAngle}, ParameterRange{});
}

void check_clearance(CheckRules& rules, const RevoluteClearance& joint, const std::string& subject,
                     const std::string& path) {
  using dimension::kLength;
  const CheckRules::Value radius{subject, path + ".bearing_radius", joint.bearing_radius, kLength};
  const CheckRules::Value clearance{subject, path + ".radial_clearance", joint.radial_clearance, kLength};
  rules.check_range("E-MODEL-012", radius, kPositive);
  rules.check_range("E-MODEL-012", clearance, kPositive);
  rules.check_range("E-MODEL-012", {subject, path + ".width", joint.width, kLength}, kPositive);
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

void check_prismatic(CheckRules& rules, const Prismatic& joint, const std::string& subject, const std::string& path) {
  const ParameterRange any;
  check_angle(rules, subject, path + ".direction", joint.direction);
  check_angle(rules, subject, path + ".relative_angle", joint.relative_angle);
  if (joint.start_displacement) {
    const double displacement = *joint.start_displacement;
    rules.check_range("E-MODEL-005", {subject, path + ".start.displacement", displacement, dimension::kLength}, any);
  }
  if (joint.start_speed) {
    rules.check_range("E-MODEL-005", {subject, path + ".start.speed", *joint.start_speed, dimension::kSpeed}, any);
  }
}

void check_joint(CheckRules& rules, const Joint& joint) {
  const std::string subject = fmt::format("joint '{}'", joint.name);
  const std::string path = fmt::format("joints.{}", joint.name);
  const auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
  const auto [first, second] = anchors(joint.kind);
  check_anchor(rules, subject, path + (clearance != nullptr ? ".bearing" : ".between.0"), first);
  check_anchor(rules, subject, path + (clearance != nullptr ? ".journal" : ".between.1"), second);
  if (first.body == second.body && !first.body.empty()) {
    rules.diagnostics.error("E-MODEL-023", path + (clearance != nullptr ? ".journal" : ".between"),
                            fmt::format("{} connects body '{}' with itself", subject, first.body));
  }
  if (clearance != nullptr) check_clearance(rules, *clearance, subject, path);
  if (const auto* slide = std::get_if<Prismatic>(&joint.kind)) check_prismatic(rules, *slide, subject, path);
  if (const auto* rigid = std::get_if<Rigid>(&joint.kind)) {
    check_angle(rules, subject, path + ".relative_angle", rigid->relative_angle);
  }
}

}  // namespace

void check_anchor(CheckRules& rules, const std::string& subject, const std::string& path, const Anchor& anchor) {
  const Mechanism& mechanism = rules.mechanism;
  const int index = find_body(mechanism, anchor.body);
  if (index < 0) {
    rules.report_unknown(
        "E-MODEL-021", path,
        fmt::format("{} is on '{}.{}', and no body has the name '{}'", subject, anchor.body, anchor.point, anchor.body),
        anchor.body, "bodies", list_names(mechanism.bodies));
    return;
  }
  const Body& body = mechanism.bodies[index];
  if (find_point(body, anchor.point) != nullptr) return;
  rules.report_unknown("E-MODEL-022", path,
                       fmt::format("{} is on '{}.{}', and body '{}' has no point '{}'", subject, anchor.body,
                                   anchor.point, anchor.body, anchor.point),
                       anchor.point, fmt::format("points of '{}'", body.name), list_names(body.points));
}

void check_joints(CheckRules& rules) {
  for (const Joint& joint : rules.mechanism.joints) check_joint(rules, joint);
}

}  // namespace gudgeon
