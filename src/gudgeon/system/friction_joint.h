// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// An ideal joint with friction, compiled, and what its friction does at one instant (docs/theory/friction.md).
#pragma once

#include "gudgeon/model/mechanism.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

enum class FrictionKind {
  pin,    ///< a torque about a revolute joint, by the whole force that it carries (Eq. F11)
  guide,  ///< a force along a prismatic joint, by force across and moment at the block's two ends (Eq. F12)
  slot,   ///< a force on the surface of a pin, by the force that the wall gives it (Eq. F13)
};

/// An ideal joint with friction: its law, sizes, and where its points and bodies are in the tables.
struct FrictionJoint {
  int joint = 0;  ///< index into Mechanism::joints
  FrictionKind kind = FrictionKind::pin;
  int first_turn = 0;
  int second_turn = 0;
  double first_offset = 0.0;  ///< body angle − turn angle [rad]
  int first_index = 0;        ///< equation of the first body's turn
  int second_index = 0;
  int first_row = -1;      ///< of the first anchor in the chain of points; -1 for a pin
  int second_row = -1;     ///< of the second
  double direction = 0.0;  ///< [rad] of the line in the first body's axes
  int first_action = 0;    ///< index of its torque or force among those of all joints; a slot's torque follows
  JointFriction friction;
  int bristle = -1;            ///< index of the bristle's deflection in the state, -1 without one
  double bristle_scale = 0.0;  ///< [m] deflection at which the bristle slips
};

/// How many torques and forces are unknown of one joint.
constexpr int count_actions(FrictionKind kind) { return kind == FrictionKind::slot ? 2 : 1; }

/// What acts on a joint's second body; the first one feels the opposite at the same place.
struct FrictionPair {
  Vec2 force;           ///< [N] at the second anchor
  double torque = 0.0;  ///< [N m]
};

/// Friction of one joint at one instant.
struct FrictionForces {
  FrictionPair pair;
  double slip_speed = 0.0;    ///< v [m/s] of the second body's surface on the first one's
  double force = 0.0;         ///< [N] on the second body's surface, along v
  double power = 0.0;         ///< [W] lost
  double bristle_rate = 0.0;  ///< ż [m/s], where the law has a bristle
};

/// The bodies whose reactions friction follows.
struct FrictionBodies {
  Mechanism mechanism;
  Topology topology;
};

}  // namespace gudgeon
