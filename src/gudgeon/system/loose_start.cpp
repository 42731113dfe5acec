// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Shifts of whole loose groups.
#include "gudgeon/system/loose_start.h"

#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

namespace {

Vec2 find_world(const Mechanism& mechanism, const Assembly& assembly, const Anchor& anchor) {
  const int body = find_body(mechanism, anchor.body);
  return assembly.poses[body].find_point(find_point(mechanism.bodies[body], anchor.point)->position);
}

/// A spring whose points coincide pulls in no direction.
void check_springs(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics) {
  constexpr double kNoLength = 1e-12;  // [m] what rounding leaves of the distance of two points that coincide
  for (const Load& load : mechanism.loads) {
    const auto* spring = std::get_if<Spring>(&load.kind);
    if (spring == nullptr) continue;
    const Vec2 first = find_world(mechanism, assembly, spring->first);
    const double scale = std::max(norm(first), 1.0);
    if (norm(find_world(mechanism, assembly, spring->second) - first) > kNoLength * scale) continue;
    diagnostics.error(
        "E-MODEL-075", "loads." + load.name,
        fmt::format("load '{}': its two points coincide at the start, so the spring has no direction", load.name),
        {"a bushing pulls two points together from wherever they are"});
  }
}

}  // namespace

void place_loose_bodies(const Mechanism& mechanism, Assembly& assembly) {
  const Topology topology = find_topology(mechanism);
  const auto find_root = [&](int body) {
    while (topology.bodies[body].parent >= 0) body = topology.bodies[body].parent;
    return body;
  };
  for (const auto& [loose, slide] : topology.loose) {
    const BodyStart& start = mechanism.bodies[loose].start;
    const BodyPose& pose = assembly.poses[loose];
    const Vec2 shift = start.position.value_or(pose.position) - pose.position;
    const Vec2 push = start.velocity.value_or(pose.velocity) - pose.velocity;
    for (int body = 0; body < static_cast<int>(assembly.poses.size()); ++body) {
      if (find_root(body) != loose) continue;
      assembly.poses[body].position += shift;
      assembly.poses[body].velocity += push;
    }
  }
}

void require_clear_start(const Mechanism& mechanism, const Assembly& assembly) {
  // A journal may be given to touch; rounding of its position must not count as overlap.
  constexpr double kTouching = 1e-9;
  Diagnostics diagnostics;
  for (const Joint& joint : mechanism.joints) {
    const auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
    if (clearance == nullptr) continue;
    const double eccentricity =
        norm(find_world(mechanism, assembly, clearance->journal) - find_world(mechanism, assembly, clearance->bearing));
    if (eccentricity <= clearance->radial_clearance * (1.0 + kTouching)) continue;
    diagnostics.error("E-MODEL-074", "joints." + joint.name,
                      fmt::format("joint '{}': its journal starts {:.6g} mm off the middle of its bearing, and "
                                  "radial_clearance is {:.6g} mm",
                                  joint.name, 1e3 * eccentricity, 1e3 * clearance->radial_clearance),
                      {"change start.position of the loose body, or leave it out: journals then start in the middle"});
  }
  check_springs(mechanism, assembly, diagnostics);
  if (diagnostics.has_errors()) throw ModelError(diagnostics);
}

}  // namespace gudgeon
