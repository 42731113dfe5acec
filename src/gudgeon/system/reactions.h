// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Forces in the ideal joints, by one backward Newton-Euler sweep over a solved state.
#pragma once

#include <array>
#include <vector>

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
  struct LoadEnds {
    int first = -1;   // body that feels the opposite, or none
    Anchored second;  // where the force acts
  };

  void apply_loads(const Workspace& workspace) noexcept;
  void apply_contacts(const Workspace& workspace) noexcept;
  void apply_closures(const Workspace& workspace) noexcept;
  void apply_driver_torques(const Workspace& workspace) noexcept;
  void remove_driver_forces(const Workspace& workspace, const std::vector<BodyMotion>& motions) noexcept;

  const System* system_;
  JointSweep sweep_;
  SelfStress self_stress_;
  std::vector<std::array<int, 2>> driven_angles_;  // one a driver of the tables: its body and the other; -1 for a slide
  std::vector<Anchored> contact_points_;           // one a contact: the centre of its circle
  std::vector<LoadEnds> load_ends_;                // one a load
};

}  // namespace gudgeon
