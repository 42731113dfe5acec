// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One remark a pair of pins.
#include "gudgeon/system/pinned_remarks.h"

#include <fmt/format.h>

#include "gudgeon/system/pinned_bodies.h"

namespace gudgeon {

Diagnostics remark_pinned_bodies(const Mechanism& mechanism) {
  const std::vector<JointEnds> ends = find_joint_ends(mechanism);
  Diagnostics diagnostics;
  for (const PinnedPair& pair : find_pinned_bodies(mechanism, ends).pairs) {
    const std::string& joint = mechanism.joints[pair.joint].name;
    const auto name = [&](const JointEnd& end) -> const std::string& { return mechanism.bodies[end.body].name; };
    const auto& [first, second] = ends[pair.joint];
    diagnostics.remark("R-MODEL-140", "joints." + joint,
                       fmt::format("joints '{}' and '{}' hold '{}' and '{}' as one rigid body",
                                   mechanism.joints[pair.other].name, joint, name(first), name(second)),
                       {"they move as one; how the two pins share a load along the line between them depends on their "
                        "fit, which is not modelled: the least forces are given"});
  }
  return diagnostics;
}

}  // namespace gudgeon
