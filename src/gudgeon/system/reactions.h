// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Forces in the ideal joints, by one backward Newton-Euler sweep over a solved state.
#pragma once

#include <vector>

#include "gudgeon/system/reaction_sweep.h"
#include "gudgeon/system/self_stress.h"

namespace gudgeon {

/// Finds the reactions of all joints; compiled once, holds its own scratch memory. Where constraints imply each other
/// the reactions are the least of all that balance the bodies, see SelfStress. The effort of a driven slide is not part
/// of its joint's force.
class ReactionFinder {
 public:
  /// Keeps a reference.
  explicit ReactionFinder(const System& system);
  explicit ReactionFinder(const System&&) = delete;

  /// From the workspace's last eval_dynamics and the motions of the same state; one entry a joint.
  const std::vector<JointReaction>& update(const Workspace& workspace, const std::vector<BodyMotion>& motions) noexcept;

  [[nodiscard]] const std::vector<JointReaction>& reactions() const { return sweep_.reactions(); }

  /// Moment [N m] left over on the root body of each group of tied bodies: the driver's torque on a driven one, zero on
  /// a free one, the ground's on the frame. One entry a turn, after update().
  [[nodiscard]] const std::vector<double>& root_moments() const { return sweep_.root_moments(); }

 private:
  const System* system_;
  ReactionSweep sweep_;
  SelfStress self_stress_;
};

}  // namespace gudgeon
