// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which points of which bodies joints connect, names looked up once.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "gudgeon/base/vec2.h"
#include "gudgeon/model/mechanism.h"

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

/// Bodies and their points by name, in constant time. Keeps references to the mechanism.
class AnchorIndex {
 public:
  explicit AnchorIndex(const Mechanism& mechanism);

  /// The index of a body that exists.
  [[nodiscard]] int find_body(std::string_view name) const { return bodies_.find(name)->second; }
  /// A point that exists.
  [[nodiscard]] JointEnd find(const Anchor& anchor) const;

 private:
  std::unordered_map<std::string_view, int> bodies_;
  std::vector<std::unordered_map<std::string_view, Vec2>> points_;  // one a body
};

/// One entry a joint.
std::vector<JointEnds> find_joint_ends(const Mechanism& mechanism);

}  // namespace gudgeon
