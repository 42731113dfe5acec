// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Shifts of whole loose groups.
#include "gudgeon/system/loose_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

namespace {

// Which bodies move along when one is shifted: those of its tree, and trees that a pin in a slot ties to it. One entry
// a body; a cluster has the number of one of its bodies, the frame's has 0.
std::vector<int> find_clusters(const Mechanism& mechanism, const Topology& topology) {
  std::vector<int> cluster(mechanism.bodies.size());
  for (std::size_t b = 0; b < cluster.size(); ++b) {
    int root = static_cast<int>(b);
    while (topology.bodies[root].parent >= 0) root = topology.bodies[root].parent;
    cluster[b] = root;
  }
  for (const Closure& closure : topology.closures) {
    if (closure.joint < 0) continue;
    const auto [first, second] = anchors(mechanism.joints[closure.joint].kind);
    const auto [low, high] =
        std::minmax({cluster[find_body(mechanism, first.body)], cluster[find_body(mechanism, second.body)]});
    std::ranges::replace(cluster, high, low);
  }
  return cluster;
}

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
        {"give it two points apart, or use a bushing, which pulls two points together from wherever they are"});
  }
}

}  // namespace

void place_loose_bodies(const Mechanism& mechanism, Assembly& assembly) {
  const Topology topology = find_topology(mechanism);
  const std::vector<int> cluster = find_clusters(mechanism, topology);
  std::vector<bool> placed(cluster.size(), false);
  placed[0] = true;
  for (const auto& [loose, slide] : topology.loose) {
    const BodyStart& start = mechanism.bodies[loose].start;
    if (placed[cluster[loose]] || (!start.position && !start.velocity)) continue;
    placed[cluster[loose]] = true;
    const BodyPose pose = assembly.poses[loose];
    const Vec2 shift = start.position.value_or(pose.position) - pose.position;
    const Vec2 push = start.velocity.value_or(pose.velocity) - pose.velocity;
    for (std::size_t body = 0; body < cluster.size(); ++body) {
      if (cluster[body] != cluster[loose]) continue;
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
