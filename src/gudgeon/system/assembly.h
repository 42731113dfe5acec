// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Assembly: from guessed to exact positions and velocities of all bodies, with every joint closed.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/vec2.h"
#include "gudgeon/model/mechanism.h"

namespace gudgeon {

/// Where a body is and how it moves; position and velocity are of the body's origin.
struct BodyPose {
  Vec2 position;            ///< [m]
  double angle = 0.0;       ///< [rad]
  Vec2 velocity;            ///< [m/s]
  double angle_rate = 0.0;  ///< [rad/s]

  [[nodiscard]] Vec2 find_point(Vec2 local) const { return position + make_rotation(angle) * local; }
};

/// How a loop of the mechanism closed: at which joint, and to which side it folds there.
struct LoopBranch {
  std::string joint;
  std::string first_body;
  std::string second_body;
  double fold = 0.0;  ///< sine of the turn from the loop's first link to its second; its sign names the branch
};

struct Assembly {
  std::vector<BodyPose> poses;        ///< one a body, in the mechanism's order
  std::vector<LoopBranch> branches;   ///< one a closed loop
  double closure_residual = 0.0;      ///< [m] largest gap left in a joint
  std::vector<double> angle_changes;  ///< [rad] a body: assembled minus guessed angle; a given one is the guess
  std::vector<int> held_bodies;       ///< whose given angle was no guess: joints, drivers or a tied body say another
};

/// Places every body at the given time, clearance joints as if they were ideal. Bodies keep the angles and
/// displacements guessed for them as nearly as the joints and drivers permit; a body that only clearance joints hold is
/// then moved to the start position and velocity given for it.
/// Loops fold to the side that their joint's branch asks for.
/// Throws ModelError when the joints cannot be closed, naming the joint and its gap, when a branch cannot be had, or
/// when start speeds conflict.
Assembly assemble(const Mechanism& mechanism, double time = 0.0);

}  // namespace gudgeon
