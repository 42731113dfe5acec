// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bodies: mass, inertia, points and guessed start.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <string>
#include <string_view>

#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

std::vector<Point> read_points(TableReader& body) {
  std::vector<Point> points;
  auto table = body.find_table("points", fmt::format("{}: points", body.subject()));
  if (!table) return points;
  for (const DocumentEntry& entry : table->entries()) {
    // A point that cannot be read is kept, so that the joints on it are not reported as well.
    const auto position = table->read_vector(entry.node, table->path_of(entry.key), dimension::kLength);
    points.push_back({entry.key, position.value_or(Vec2{})});
  }
  return points;
}

BodyStart read_start(TableReader& body) {
  BodyStart start;
  auto table = body.find_table("start", fmt::format("{}: start", body.subject()));
  if (!table) return start;
  start.angle = table->find_quantity("angle", dimension::kAngle);
  start.angle_rate = table->find_quantity("angle_rate", dimension::kAngularSpeed);
  start.position = table->find_vector("position", dimension::kLength);
  start.velocity = table->find_vector("velocity", dimension::kSpeed);
  table->check_unknown_keys();
  return start;
}

constexpr std::array<std::string_view, 11> kNamesOfFrames{"ground", "base",       "fixed",  "world",   "chassis", "bed",
                                                          "stand",  "foundation", "static", "housing", "link0"};

bool lacks_mass(const DocumentEntry& body) {
  const DocumentNode::Table* keys = body.node.table();
  return keys != nullptr && find_node(*keys, "mass") == nullptr && find_node(*keys, "inertia") == nullptr;
}

/// Whether a body without mass is likely to be the one that stands still, under another name than "frame": by its name,
/// or because it is the only one like that and there is no frame.
bool may_be_frame(const DocumentEntry& body, const DocumentNode::Table& bodies) {
  if (!lacks_mass(body)) return false;
  std::string name = body.key;
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::ranges::any_of(kNamesOfFrames, [&](std::string_view n) { return name.starts_with(n); })) return true;
  return find_node(bodies, kFrameName) == nullptr && std::ranges::count_if(bodies, lacks_mass) == 1;
}

void report_frame(TableReader& body) {
  for (const std::string_view key : {"mass", "inertia"}) body.find(key);
  body.report("E-FILE-002", "mass", "mass and inertia are missing",
              {fmt::format("the body that stands still is called '{}' and has points only: if this is it, name it so, "
                           "here and in the joints",
                           kFrameName)});
}

Body read_body(const DocumentEntry& entry, const DocumentNode::Table& bodies, ReadLog& log) {
  Body body;
  body.name = entry.key;
  TableReader table{entry.node, "bodies." + entry.key, fmt::format("body '{}'", entry.key), log};
  // The frame does not move: it has points and nothing else.
  if (body.name != kFrameName) {
    if (may_be_frame(entry, bodies)) {
      report_frame(table);
      body.mass = body.inertia = std::numeric_limits<double>::quiet_NaN();  // as what cannot be read
    } else {
      body.mass = table.read_quantity("mass", dimension::kMass);
      body.inertia = table.read_quantity("inertia", dimension::kInertia);
    }
    body.center_of_mass = table.find_vector("center_of_mass", dimension::kLength).value_or(Vec2{});
    body.start = read_start(table);
  }
  body.points = read_points(table);
  table.check_unknown_keys();
  return body;
}

}  // namespace

std::vector<Body> read_bodies(TableReader& root) {
  std::vector<Body> bodies;
  if (auto table = root.find_table("bodies", "bodies")) {
    for (const DocumentEntry& entry : table->entries())
      bodies.push_back(read_body(entry, table->entries(), root.log()));
  }
  const auto frame = std::ranges::find(bodies, kFrameName, &Body::name);
  if (frame != bodies.end()) {
    std::rotate(bodies.begin(), frame, frame + 1);
  } else {
    bodies.insert(bodies.begin(), Body{})->name = kFrameName;
  }
  return bodies;
}

}  // namespace gudgeon
