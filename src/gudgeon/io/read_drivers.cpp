// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Drivers: what moves a mechanism.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "gudgeon/io/field_reader.h"
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
  return slide == nullptr ? 0.0 : slide->start.displacement.value_or(0.0);
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
void read_given_motion(const DocumentNode& node, Dimension dimension, TableReader& table, Driver& driver) {
  const std::string key{Driver::kMotionKey};
  Function motion = read_function(node, table.path_of(key), dimension, read_constants(table), table);
  if (auto* expression = std::get_if<Expression>(&motion)) {
    driver.motion = std::move(*expression);
  } else if (auto* curve = std::get_if<SampledCurve>(&motion)) {
    driver.motion = std::move(*curve);
  } else {
    const double place = std::get<double>(motion);
    driver.start = std::isfinite(place) ? place : 0.0;  // what could not be read has been reported
  }
  for (const char* uniform : {"start", "speed"}) {
    if (table.find(uniform) == nullptr || table.is_newer(key, uniform)) continue;
    table.report("E-FILE-013", uniform, fmt::format("{} and {} exclude each other", key, uniform),
                 {"motion says where the driver is at every time, its start too"});
  }
}

/// The driver comes with the start that holds unless one is given.
template <class Driven>
void read_motion(TableReader& table, Driver& driver) {
  const DocumentNode* motion = table.find(Driver::kMotionKey);
  if (motion != nullptr && !table.is_newer("speed", Driver::kMotionKey)) {
    driver.start = 0.0;
    read_given_motion(*motion, Driven::kPlace, table, driver);
    return;
  }
  if (motion != nullptr) table.find("constants");  // those of the motion that speed replaces
  FieldReader(table).read(Driver::uniform_fields(Driven::kPlace, Driven::kRate), driver);
}

std::optional<Driver> read_driver(const DocumentEntry& entry, const Mechanism& mechanism, ReadLog& log) {
  Driver driver;
  driver.name = entry.key;
  TableReader table{entry.node, "drivers." + entry.key, fmt::format("driver '{}'", entry.key), log};
  if (!check_one_of(table, "body", "slide")) return std::nullopt;
  FieldReader reader(table);
  if (table.has("body")) {
    DrivenAngle angle;
    reader.read(angle);
    driver.start = find_body_start(mechanism, angle.body) - find_body_start(mechanism, angle.against);
    driver.target = std::move(angle);
    read_motion<DrivenAngle>(table, driver);
  } else {
    DrivenSlide slide;
    reader.read(slide);
    driver.start = find_slide_start(mechanism, slide.joint);
    driver.target = std::move(slide);
    read_motion<DrivenSlide>(table, driver);
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
