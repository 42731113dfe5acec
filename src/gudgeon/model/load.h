// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads: forces and torques, constant or variable, springs and dampers.
#pragma once

#include <string>
#include <variant>

#include "gudgeon/base/vec2.h"
#include "gudgeon/model/body.h"
#include "gudgeon/model/function.h"
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

/// A force on a point of a body that depends on time or on the mechanism's position and speed.
struct VariableForce {
  Anchor point;
  Function x = 0.0;  ///< [N] along the x axis of `axes`
  Function y = 0.0;  ///< [N] along its y axis
  std::string axes = kFrameName;
};

/// A torque on a body, and its opposite on another.
struct VariableTorque {
  std::string body;
  std::string against = kFrameName;
  Function torque = 0.0;  ///< [N m] on `body`, counter-clockwise
};

/// Spring and damper along the line between two points: pull F = k (L − L₀) + d L̇ on both, towards each other.
struct Spring {
  Anchor first;
  Anchor second;
  double stiffness = 0.0;    ///< k [N/m]
  double damping = 0.0;      ///< d [N s/m]
  double free_length = 0.0;  ///< L₀ [m]
};

/// Torsion spring and damper: torque M = −k (θ − θ₀) − d θ̇ on the second body and −M on the first, θ = θ_second −
/// θ_first.
struct TorsionSpring {
  std::string first;
  std::string second;
  double stiffness = 0.0;   ///< k [N m/rad]
  double damping = 0.0;     ///< d [N m s/rad]
  double free_angle = 0.0;  ///< θ₀ [rad]
};

/// An elastic joint: with r the second point against the first, in the first body's axes, and θ = θ_second − θ_first,
/// the second body feels F = −k r − d ṙ (each component its own) at its point and M = −k_θ (θ − θ₀) − d_θ θ̇. ṙ is what
/// an observer on the first body sees.
struct Bushing {
  Anchor first;
  Anchor second;
  Vec2 stiffness;                  ///< k [N/m] along the first body's x and y
  Vec2 damping;                    ///< d [N s/m]
  double angular_stiffness = 0.0;  ///< k_θ [N m/rad]
  double angular_damping = 0.0;    ///< d_θ [N m s/rad]
  double free_angle = 0.0;         ///< θ₀ [rad]
};

using AnyLoad =
    std::variant<ConstantForce, ConstantTorque, VariableForce, VariableTorque, Spring, TorsionSpring, Bushing>;

struct Load {
  std::string name;
  AnyLoad kind;
};

}  // namespace gudgeon
