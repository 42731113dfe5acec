// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sums along the paths to the bodies' origins.
#include "gudgeon/system/poses.h"

namespace gudgeon {

BodyPose find_pose(const BodyNode& node, const Coordinates& coordinates) {
  BodyPose pose;
  pose.angle = coordinates.angle[node.turn] + node.offset;
  pose.angle_rate = coordinates.angle_rate[node.turn];
  for (const Term& term : node.origin) {
    const Vec2 arm = coordinates.rotation[term.turn] * term.vector;
    const double scale = coordinates.slide[term.slide];
    pose.position += scale * arm;
    pose.velocity += coordinates.slide_rate[term.slide] * arm + scale * coordinates.angle_rate[term.turn] * perp(arm);
  }
  return pose;
}

std::vector<BodyPose> find_poses(const Mechanism& mechanism, const Topology& topology, const Coordinates& coordinates) {
  std::vector<BodyPose> poses(mechanism.bodies.size());
  for (std::size_t b = 1; b < poses.size(); ++b) poses[b] = find_pose(topology.bodies[b], coordinates);
  return poses;
}

}  // namespace gudgeon
