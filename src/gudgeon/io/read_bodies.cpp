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

#include "gudgeon/io/field_reader.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

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
  body.report("E-FILE-002", "mass", "mass and inertia are missing",
              {fmt::format("the body that stands still is called '{}' and has points only: if this is it, name it so, "
                           "here and in the joints",
                           kFrameName)});
}

Body read_body(const DocumentEntry& entry, const DocumentNode::Table& bodies, ReadLog& log) {
  Body body;
  body.name = entry.key;
  TableReader table{entry.node, "bodies." + entry.key, fmt::format("body '{}'", entry.key), log};
  FieldReader reader(table);
  if (body.name != kFrameName) {
    if (may_be_frame(entry, bodies)) {
      report_frame(table);
      body.mass = body.inertia = std::numeric_limits<double>::quiet_NaN();  // as what cannot be read
    } else {
      reader.read(Body::kMassFields, body);
    }
    reader.read(Body::kPlaceFields, body);
  }
  reader.read(Body::kPointFields, body);
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
