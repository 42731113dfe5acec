// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for bodies: mass, inertia, and how they hang together.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/model/check_fields.h"

namespace gudgeon {

namespace {

/// Which bodies an ideal joint holds, one entry a body.
std::vector<bool> list_held(const CheckRules& rules) {
  std::vector<bool> held(rules.mechanism.bodies.size(), false);
  for (const Joint& joint : rules.mechanism.joints) {
    if (has_clearance(joint.kind)) continue;
    const auto [first, second] = anchors(joint.kind);
    for (const std::string* name : {&first.body, &second.body}) {
      if (const int body = rules.names.find_body(*name); body >= 0) held[body] = true;
    }
  }
  return held;
}

void check_inertia(CheckRules& rules, const Body& body, bool is_held, const std::string& path) {
  const std::string subject = fmt::format("body '{}'", body.name);
  const CheckRules::Value inertia{subject, path + ".inertia", body.inertia, dimension::kInertia};
  if (body.inertia != 0.0 || is_held) return;
  rules.diagnostics.error("E-MODEL-006", path + ".inertia",
                          fmt::format("{}: inertia is {}; only a body on an ideal joint may be a point mass", subject,
                                      rules.describe(inertia)),
                          {"a body that is free to turn about its centre of mass needs an inertia above 0"});
}

void check_body(CheckRules& rules, const Body& body, bool is_held) {
  const std::string subject = fmt::format("body '{}'", body.name);
  const std::string path = fmt::format("bodies.{}", body.name);
  FieldCheck fields(rules, subject, path);
  fields.check(Body::kPointFields, body);
  if (body.name == kFrameName) return;
  fields.check(Body::kMassFields, body);
  fields.check(Body::kPlaceFields, body);
  check_inertia(rules, body, is_held, path);
}

/// Which bodies every body is tied to by joints, one list a body.
std::vector<std::vector<int>> list_tied(const CheckRules& rules) {
  std::vector<std::vector<int>> tied(rules.mechanism.bodies.size());
  for (const Joint& joint : rules.mechanism.joints) {
    const auto [first, second] = anchors(joint.kind);
    const int a = rules.names.find_body(first.body);
    const int b = rules.names.find_body(second.body);
    if (a < 0 || b < 0) continue;
    tied[a].push_back(b);
    tied[b].push_back(a);
  }
  return tied;
}

/// Marks the given body and every one that joints tie to it; returns them in the order of the model.
std::vector<int> update_reached(const std::vector<std::vector<int>>& tied, int from, std::vector<bool>& reached) {
  std::vector<int> island{from};
  reached[from] = true;
  for (std::size_t k = 0; k < island.size(); ++k) {
    for (const int body : tied[island[k]]) {
      if (reached[body]) continue;
      reached[body] = true;
      island.push_back(body);
    }
  }
  std::ranges::sort(island);
  return island;
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
  const std::vector<std::vector<int>> tied = list_tied(rules);
  std::vector<bool> reached(tied.size(), false);
  update_reached(tied, 0, reached);
  for (int b = 0; b < static_cast<int>(reached.size()); ++b) {
    if (reached[b]) continue;
    std::vector<std::string> island;
    for (const int body : update_reached(tied, b, reached)) island.push_back(rules.mechanism.bodies[body].name);
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
  const std::vector<bool> held = list_held(rules);
  for (std::size_t b = 0; b < bodies.size(); ++b) check_body(rules, bodies[b], held[b]);
  check_connections(rules);
}

}  // namespace gudgeon
