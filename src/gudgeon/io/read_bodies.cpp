// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bodies: mass, inertia, points and guessed start.
#include <fmt/format.h>

#include <algorithm>

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

Body read_body(const DocumentEntry& entry, ReadLog& log) {
  Body body;
  body.name = entry.key;
  TableReader table{entry.node, "bodies." + entry.key, fmt::format("body '{}'", entry.key), log};
  // The frame does not move: it has points and nothing else.
  if (body.name != kFrameName) {
    body.mass = table.read_quantity("mass", dimension::kMass);
    body.inertia = table.read_quantity("inertia", dimension::kInertia);
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
    for (const DocumentEntry& entry : table->entries()) bodies.push_back(read_body(entry, root.log()));
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
