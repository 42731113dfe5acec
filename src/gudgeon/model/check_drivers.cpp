// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for drivers and loads: what they act on.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

// Start angles that differ by less are the same number written twice.
constexpr double kSameAngle = 1e-9;

bool check_body_target(CheckRules& rules, const Driver& driver, const std::string& path, const std::string& body) {
  const int index = find_body(rules.mechanism, body);
  if (index < 0) {
    rules.report_unknown("E-MODEL-040", path + ".body",
                         fmt::format("driver '{}' drives body '{}', and no body has that name", driver.name, body),
                         body, "bodies", list_names(rules.mechanism.bodies));
    return false;
  }
  if (body == kFrameName) {
    rules.diagnostics.error("E-MODEL-041", path + ".body",
                            fmt::format("driver '{}' drives the frame, which does not move", driver.name));
    return false;
  }
  const std::optional<double> guess = rules.mechanism.bodies[index].start.angle;
  if (guess && std::abs(*guess - driver.start) > kSameAngle) {
    rules.diagnostics.remark(
        "R-MODEL-107", path + ".start",
        fmt::format("driver '{}' starts at {:.6g} rad, body '{}' at {:.6g} rad; the driver's holds", driver.name,
                    driver.start, body, *guess));
  }
  return true;
}

bool check_slide_target(CheckRules& rules, const Driver& driver, const std::string& path, const std::string& joint) {
  const int index = find_joint(rules.mechanism, joint);
  if (index < 0) {
    rules.report_unknown("E-MODEL-040", path + ".slide",
                         fmt::format("driver '{}' drives joint '{}', and no joint has that name", driver.name, joint),
                         joint, "joints", list_names(rules.mechanism.joints));
    return false;
  }
  if (std::holds_alternative<Prismatic>(rules.mechanism.joints[index].kind)) return true;
  rules.diagnostics.error("E-MODEL-043", path + ".slide",
                          fmt::format("driver '{}' drives joint '{}', which is not prismatic", driver.name, joint));
  return false;
}

void check_driver(CheckRules& rules, const Driver& driver, std::set<std::string>& seen) {
  const std::string subject = fmt::format("driver '{}'", driver.name);
  const std::string path = fmt::format("drivers.{}", driver.name);
  const auto* angle = std::get_if<DrivenAngle>(&driver.target);
  const auto* slide = std::get_if<DrivenSlide>(&driver.target);
  const std::string target =
      angle != nullptr ? fmt::format("body '{}'", angle->body) : fmt::format("joint '{}'", slide->joint);
  const bool good = angle != nullptr ? check_body_target(rules, driver, path, angle->body)
                                     : check_slide_target(rules, driver, path, slide->joint);
  if (good && !seen.insert(target).second) {
    rules.diagnostics.error("E-MODEL-042", path, fmt::format("{} has more than one driver", target));
  }
  const ParameterRange any;
  const Dimension start = angle != nullptr ? dimension::kAngle : dimension::kLength;
  const Dimension speed = angle != nullptr ? dimension::kAngularSpeed : dimension::kSpeed;
  rules.check_range("E-MODEL-005", {subject, path + ".start", driver.start, start}, any);
  rules.check_range("E-MODEL-005", {subject, path + ".speed", driver.speed, speed}, any);
}

}  // namespace

void check_drivers(CheckRules& rules) {
  std::set<std::string> seen;
  for (const Driver& driver : rules.mechanism.drivers) check_driver(rules, driver, seen);
}

void check_loads(CheckRules& rules) {
  for (const Load& load : rules.mechanism.loads) {
    const std::string subject = fmt::format("load '{}'", load.name);
    const std::string path = fmt::format("loads.{}", load.name);
    if (const auto* force = std::get_if<ConstantForce>(&load.kind)) {
      check_anchor(rules, subject, path + ".point", force->point);
      rules.check_finite(subject, path + ".force", force->force);
    }
    if (const auto* torque = std::get_if<ConstantTorque>(&load.kind)) {
      if (find_body(rules.mechanism, torque->body) < 0) {
        rules.report_unknown("E-MODEL-050", path + ".body",
                             fmt::format("{} acts on body '{}', and no body has that name", subject, torque->body),
                             torque->body, "bodies", list_names(rules.mechanism.bodies));
      }
      rules.check_range("E-MODEL-005", {subject, path + ".torque", torque->torque, dimension::kTorque},
                        ParameterRange{});
    }
  }
}

}  // namespace gudgeon
