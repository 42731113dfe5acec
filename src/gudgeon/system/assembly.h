// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Assembly: from guessed to exact positions and velocities of all bodies, with every joint closed.
#pragma once

#include <optional>
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

/// Places every body at the given time. Angles, displacements and places that joints and drivers leave free are taken
/// exactly, the first ones given where there are more; those that loops determine are guesses, and choose the branch
/// where no joint asks for one. Rates are taken exactly.
/// Journals start in the middle of their bearings, but for what is given: a body that only clearance joints hold starts
/// where and as fast as it is given; given rates may move a journal within its play; and where the mechanism closes
/// only thanks to its clearance, journals are as little off centre, in shares of their clearances, as can be.
/// Throws ModelError when the joints cannot be closed, naming the joint and its gap, when a branch cannot be had, or
/// when start rates conflict.
Assembly assemble(const Mechanism& mechanism, double time = 0.0);

/// The ideal mechanism's start, made for comparison: bodies that clearance leaves loose are where their journals are in
/// the middle. None when the joints do not close without clearance, or given rates need it.
std::optional<Assembly> assemble_ideal(const Mechanism& mechanism);

/// Every way to assemble the ideal mechanism whose bodies are given as free as they are in assemble(), the branches
/// that joints ask for left aside. None at all when loops have degrees of freedom left, for then there is no counting.
std::optional<std::vector<Assembly>> find_all_assemblies(const Mechanism& mechanism);

}  // namespace gudgeon
