// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One look-up a point.
#include "gudgeon/system/joint_ends.h"

namespace gudgeon {

JointEnd find_end(const NameIndex& names, const Anchor& anchor) {
  const int body = names.find_body(anchor.body);
  return {body, names.find_point(body, anchor.point)->position};
}

std::vector<JointEnds> find_joint_ends(const Mechanism& mechanism) {
  const NameIndex names(mechanism);
  std::vector<JointEnds> ends;
  ends.reserve(mechanism.joints.size());
  for (const Joint& joint : mechanism.joints) {
    const auto [first, second] = anchors(joint.kind);
    ends.push_back({find_end(names, first), find_end(names, second)});
  }
  return ends;
}

}  // namespace gudgeon
