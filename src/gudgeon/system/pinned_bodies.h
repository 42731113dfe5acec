// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bodies that revolute joints at two places make one rigid body.
#pragma once

#include <vector>

#include "gudgeon/system/joint_ends.h"

namespace gudgeon {

/// Two joints that hold the bodies of either one at one angle.
struct PinnedPair {
  int other = 0;                ///< the earlier joint
  int joint = 0;                ///< the later one, which ties the angles of its two bodies
  double relative_angle = 0.0;  ///< of the tying joint's bodies, θ_second − θ_first [rad]
};

struct PinnedBodies {
  std::vector<int> rigid_body;    ///< one a body: bodies with the same number never move against each other
  std::vector<PinnedPair> pairs;  ///< in the order in which they join rigid bodies
  /// One a joint: both its points are one place of a rigid body that has such a pair. The inner joints of a rigid body
  /// connect all of its bodies.
  std::vector<bool> is_inner;
};

/// Distances that differ by less than this share are the same one, written with some ten digits.
inline constexpr double kSameLength = 1e-9;

/// Joins bodies by their rigid joints, and by any two revolute joints that lie equally far apart in either body; again
/// between the bodies so joined, until nothing more joins.
PinnedBodies find_pinned_bodies(const Mechanism& mechanism, const std::vector<JointEnds>& ends);

}  // namespace gudgeon
