// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Asks every part for its rules, and for names the one rule of all.
#include "gudgeon/model/check.h"

#include <fmt/format.h>

#include <set>

#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

template <class Named>
void check_names(CheckRules& rules, const std::vector<Named>& items, std::string_view section, std::string_view what) {
  std::set<std::string> seen;
  for (const Named& item : items) {
    const std::string path = fmt::format("{}.{}", section, item.name);
    rules.check_name(fmt::format("a {}", what), path, item.name);
    if (seen.insert(item.name).second) continue;
    rules.diagnostics.error("E-MODEL-002", path, fmt::format("another {} has the name '{}' already", what, item.name));
  }
}

}  // namespace

Diagnostics check(const Mechanism& mechanism, const Study& study, const SourceMap* source, bool read_with_errors) {
  CheckRules rules{mechanism, study, source, read_with_errors};
  rules.check_name("the mechanism", "name", mechanism.name);
  rules.check_finite("the mechanism", "gravity", mechanism.gravity);
  check_names(rules, mechanism.bodies, "bodies", "body");
  for (const Body& body : mechanism.bodies) {
    check_names(rules, body.points, fmt::format("bodies.{}.points", body.name), "point");
  }
  check_names(rules, mechanism.joints, "joints", "joint");
  check_names(rules, mechanism.drivers, "drivers", "driver");
  check_names(rules, mechanism.loads, "loads", "load");
  check_bodies(rules);
  check_joints(rules);
  check_contacts(rules);
  check_drivers(rules);
  check_loads(rules);
  check_study(rules);
  check_plausibility(rules);
  return rules.diagnostics;
}

}  // namespace gudgeon
