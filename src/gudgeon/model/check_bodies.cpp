// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for bodies: mass, inertia, and how they hang together.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

void check_start(CheckRules& rules, const Body& body, const std::string& subject, const std::string& path) {
  const ParameterRange any;
  const BodyStart& start = body.start;
  if (start.angle) {
    rules.check_range("E-MODEL-005", {subject, path + ".start.angle", *start.angle, dimension::kAngle}, any);
  }
  if (start.angle_rate) {
    const Dimension rate = dimension::kAngularSpeed;
    rules.check_range("E-MODEL-005", {subject, path + ".start.angle_rate", *start.angle_rate, rate}, any);
  }
  if (start.position) rules.check_finite(subject, path + ".start.position", *start.position);
  if (start.velocity) rules.check_finite(subject, path + ".start.velocity", *start.velocity);
}

bool is_held(const Mechanism& mechanism, const Body& body) {
  return std::ranges::any_of(mechanism.joints, [&](const Joint& joint) {
    const auto [first, second] = anchors(joint.kind);
    return !has_clearance(joint.kind) && (first.body == body.name || second.body == body.name);
  });
}

void check_inertia(CheckRules& rules, const Body& body, const std::string& subject, const std::string& path) {
  const CheckRules::Value inertia{subject, path + ".inertia", body.inertia, dimension::kInertia};
  rules.check_range("E-MODEL-004", inertia, kNotNegative);
  if (body.inertia != 0.0 || is_held(rules.mechanism, body)) return;
  rules.diagnostics.error("E-MODEL-006", path + ".inertia",
                          fmt::format("{}: inertia is {}; only a body on an ideal joint may be a point mass", subject,
                                      rules.describe(inertia)),
                          {"a body that is free to turn about its centre of mass needs an inertia above 0"});
}

void check_body(CheckRules& rules, const Body& body) {
  const std::string subject = fmt::format("body '{}'", body.name);
  const std::string path = fmt::format("bodies.{}", body.name);
  for (const Point& point : body.points) {
    rules.check_finite(subject, fmt::format("{}.points.{}", path, point.name), point.position);
  }
  if (body.name == kFrameName) return;
  rules.check_range("E-MODEL-003", {subject, path + ".mass", body.mass, dimension::kMass}, kPositive);
  check_inertia(rules, body, subject, path);
  rules.check_finite(subject, path + ".center_of_mass", body.center_of_mass);
  check_start(rules, body, subject, path);
}

/// Marks every body that joints tie to the given one.
void update_reached(const Mechanism& mechanism, std::size_t from, std::vector<bool>& reached) {
  reached[from] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const Joint& joint : mechanism.joints) {
      const auto [first, second] = anchors(joint.kind);
      const int a = find_body(mechanism, first.body);
      const int b = find_body(mechanism, second.body);
      if (a < 0 || b < 0 || reached[a] == reached[b]) continue;
      reached[a] = reached[b] = grown = true;
    }
  }
}

void remark_free(CheckRules& rules, const std::vector<std::string>& island) {
  const std::string path = fmt::format("bodies.{}", island.front());
  if (island.size() == 1) {
    rules.diagnostics.remark("R-MODEL-105", path,
                             fmt::format("body '{}' is touched by no joint and moves freely", island.front()));
  } else {
    rules.diagnostics.remark(
        "R-MODEL-106", path,
        fmt::format("bodies {} hang together, but no joint ties them to the frame", join_names(island)));
  }
}

void check_connections(CheckRules& rules) {
  const Mechanism& mechanism = rules.mechanism;
  std::vector<bool> reached(mechanism.bodies.size(), false);
  update_reached(mechanism, 0, reached);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i]) continue;
    const std::vector<bool> before = reached;
    update_reached(mechanism, i, reached);
    std::vector<std::string> island;
    for (std::size_t k = 0; k < reached.size(); ++k) {
      if (reached[k] && !before[k]) island.push_back(mechanism.bodies[k].name);
    }
    remark_free(rules, island);
  }
}

}  // namespace

void check_bodies(CheckRules& rules) {
  const std::vector<Body>& bodies = rules.mechanism.bodies;
  if (bodies.empty() || bodies.front().name != kFrameName) {
    rules.diagnostics.error("E-MODEL-007", "bodies", "the first body must be the frame");
    return;
  }
  if (bodies.size() == 1) rules.diagnostics.error("E-MODEL-008", "bodies", "there is no moving body");
  for (const Body& body : bodies) check_body(rules, body);
  check_connections(rules);
}

}  // namespace gudgeon
