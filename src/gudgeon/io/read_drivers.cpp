// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Drivers: what moves a mechanism.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "gudgeon/io/read_function.h"
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

/// A driver that stands still is a motion too.
void read_motion(const DocumentNode& node, Dimension dimension, TableReader& table, Driver& driver) {
  Function motion = read_function(node, table.path_of("motion"), dimension, read_constants(table), table);
  if (auto* expression = std::get_if<Expression>(&motion)) {
    driver.motion = std::move(*expression);
  } else if (auto* curve = std::get_if<SampledCurve>(&motion)) {
    driver.motion = std::move(*curve);
  } else {
    const double place = std::get<double>(motion);
    driver.start = std::isfinite(place) ? place : 0.0;  // what could not be read has been reported
  }
  for (const char* key : {"start", "speed"}) {
    if (table.find(key) == nullptr || table.is_newer("motion", key)) continue;
    table.report("E-FILE-013", key, fmt::format("motion and {} exclude each other", key),
                 {"motion says where the driver is at every time, its start too"});
  }
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
    const std::string against = table.find_text("against").value_or(kFrameName);
    driver.target = DrivenAngle{*body, against};
    default_start = find_body_start(mechanism, *body) - find_body_start(mechanism, against);
  }
  if (const auto slide = table.find_text("slide")) {
    driver.target = DrivenSlide{*slide};
    default_start = find_slide_start(mechanism, *slide);
    start = dimension::kLength;
    speed = dimension::kSpeed;
  }
  const DocumentNode* motion = table.find("motion");
  if (motion != nullptr && !table.is_newer("speed", "motion")) {
    read_motion(*motion, start, table, driver);
  } else {
    if (motion != nullptr) table.find("constants");  // those of the motion that speed replaces
    driver.start = table.find_quantity("start", start).value_or(default_start);
    driver.speed = table.read_quantity("speed", speed);
  }
  table.check_unknown_keys();
  return driver;
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

}  // namespace gudgeon
