// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Groups of bodies whose relative angles never change.
#pragma once

#include <vector>

#include "gudgeon/system/pinned_bodies.h"

namespace gudgeon {

struct AngleGroups {
  std::vector<int> group;      ///< one a body
  std::vector<double> offset;  ///< one a body: its angle − its group's angle [rad]
  std::vector<int> ties;       ///< joints that tie bodies together
  std::vector<int> redundant;  ///< joints whose angle condition the ties already imply
  int n_groups = 0;
};

/// Joins bodies by their prismatic and rigid joints, and where they are pinned twice. The frame is in group 0 with
/// offset 0. Throws ModelError when a ring of such joints asks for two different relative angles.
AngleGroups find_angle_groups(const Mechanism& mechanism, const std::vector<JointEnds>& ends,
                              const std::vector<PinnedPair>& pairs);

}  // namespace gudgeon
