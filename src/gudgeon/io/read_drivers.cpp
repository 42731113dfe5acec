// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Drivers and loads: what moves a mechanism.
#include <fmt/format.h>

#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

double find_body_start(const Mechanism& mechanism, const std::string& name) {
  const int index = find_body(mechanism, name);
  return index < 0 ? 0.0 : mechanism.bodies[index].start.angle.value_or(0.0);
}

double find_slide_start(const Mechanism& mechanism, const std::string& name) {
  const int index = find_joint(mechanism, name);
  const auto* slide = index < 0 ? nullptr : std::get_if<Prismatic>(&mechanism.joints[index].kind);
  return slide == nullptr ? 0.0 : slide->start_displacement.value_or(0.0);
}

/// True when exactly one of two keys is there; reported otherwise.
bool check_one_of(TableReader& table, std::string_view first, std::string_view second) {
  const bool both = table.has(first) && table.has(second);
  const bool none = !table.has(first) && !table.has(second);
  if (both) table.report("E-FILE-013", second, fmt::format("{} and {} exclude each other", first, second));
  if (none) table.report("E-FILE-002", first, fmt::format("{} or {} is missing", first, second));
  return !both && !none;
}

std::optional<Driver> read_driver(const DocumentEntry& entry, const Mechanism& mechanism, ReadLog& log) {
  Driver driver;
  driver.name = entry.key;
  TableReader table{entry.node, "drivers." + entry.key, fmt::format("driver '{}'", entry.key), log};
  if (!check_one_of(table, "body", "slide")) return std::nullopt;
  double default_start = 0.0;
  Dimension start = dimension::kAngle;
  Dimension speed = dimension::kAngularSpeed;
  if (const auto body = table.find_text("body")) {
    driver.target = DrivenAngle{*body};
    default_start = find_body_start(mechanism, *body);
  }
  if (const auto slide = table.find_text("slide")) {
    driver.target = DrivenSlide{*slide};
    default_start = find_slide_start(mechanism, *slide);
    start = dimension::kLength;
    speed = dimension::kSpeed;
  }
  driver.start = table.find_quantity("start", start).value_or(default_start);
  driver.speed = table.read_quantity("speed", speed);
  table.check_unknown_keys();
  return driver;
}

std::optional<Load> read_load(const DocumentEntry& entry, ReadLog& log) {
  TableReader table{entry.node, "loads." + entry.key, fmt::format("load '{}'", entry.key), log};
  if (!check_one_of(table, "body", "point")) return std::nullopt;
  Load load{entry.key, {}};
  if (const auto body = table.find_text("body")) {
    load.kind = ConstantTorque{*body, table.read_quantity("torque", dimension::kTorque)};
  }
  if (const DocumentNode* point = table.find("point")) {
    const Anchor anchor = read_anchor(*point, table.path_of("point"), table);
    table.find_required("force");
    load.kind = ConstantForce{anchor, table.find_vector("force", dimension::kForce).value_or(Vec2{})};
  }
  table.check_unknown_keys();
  return load;
}

}  // namespace

std::vector<Driver> read_drivers(TableReader& root, const Mechanism& mechanism) {
  std::vector<Driver> drivers;
  auto all = root.find_table("drivers", "drivers");
  if (!all) return drivers;
  for (const DocumentEntry& entry : all->entries()) {
    if (auto driver = read_driver(entry, mechanism, root.log())) drivers.push_back(std::move(*driver));
  }
  return drivers;
}

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
