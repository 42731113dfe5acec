// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hash tables of names.
#include "gudgeon/system/joint_ends.h"

namespace gudgeon {

AnchorIndex::AnchorIndex(const Mechanism& mechanism) : points_(mechanism.bodies.size()) {
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    bodies_.emplace(mechanism.bodies[b].name, static_cast<int>(b));
    for (const Point& point : mechanism.bodies[b].points) points_[b].emplace(point.name, point.position);
  }
}

JointEnd AnchorIndex::find(const Anchor& anchor) const {
  const int body = find_body(anchor.body);
  return {body, points_[static_cast<std::size_t>(body)].find(anchor.point)->second};
}

std::vector<JointEnds> find_joint_ends(const Mechanism& mechanism) {
  const AnchorIndex index(mechanism);
  std::vector<JointEnds> ends;
  ends.reserve(mechanism.joints.size());
  for (const Joint& joint : mechanism.joints) {
    const auto [first, second] = anchors(joint.kind);
    ends.push_back({index.find(first), index.find(second)});
  }
  return ends;
}

}  // namespace gudgeon
