// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Constant forces and torques.
#pragma once

#include <string>
#include <variant>

#include "gudgeon/base/vec2.h"
#include "gudgeon/model/joint.h"

namespace gudgeon {

/// A constant force, in the frame's axes, on a point of a body.
struct ConstantForce {
  Anchor point;
  Vec2 force;  ///< [N]
};

/// A constant torque on a body.
struct ConstantTorque {
  std::string body;
  double torque = 0.0;  ///< [N m], counter-clockwise
};

struct Load {
  std::string name;
  std::variant<ConstantForce, ConstantTorque> kind;
};

}  // namespace gudgeon
