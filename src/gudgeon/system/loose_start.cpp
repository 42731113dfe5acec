// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Shifts of whole loose groups.
#include "gudgeon/system/loose_start.h"

#include "gudgeon/system/topology.h"

namespace gudgeon {

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

}  // namespace gudgeon
