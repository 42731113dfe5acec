// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which points of which bodies joints connect, names looked up once.
#pragma once

#include <vector>

#include "gudgeon/base/vec2.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/name_index.h"

namespace gudgeon {

/// A point of a body, in the body's axes.
struct JointEnd {
  int body = 0;
  Vec2 point;
};

/// The two points that a joint connects; the bearing's comes first.
struct JointEnds {
  JointEnd first;
  JointEnd second;
};

/// A point that exists.
JointEnd find_end(const NameIndex& names, const Anchor& anchor);

/// One entry a joint.
std::vector<JointEnds> find_joint_ends(const Mechanism& mechanism);

}  // namespace gudgeon
