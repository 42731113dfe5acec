// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Forces in the ideal joints, by one backward Newton-Euler sweep over a solved state.
#pragma once

#include <array>
#include <vector>

#include "gudgeon/system/body_motion.h"

namespace gudgeon {

/// What a joint does to its second body (the journal's, for a clearance joint), in the frame's axes. The effort of a
/// driven slide is not part of it.
struct JointReaction {
  Vec2 force;           ///< [N] at the second anchor
  double moment = 0.0;  ///< [N m] about it, of any joint but a revolute or a pin in a slot
};

/// Finds the reactions of all joints; compiled once, holds its own scratch memory. Where redundant constraints were
/// left out, their joints carry nothing: the reactions are one of many possible distributions.
class ReactionFinder {
 public:
  explicit ReactionFinder(const System& system);

  /// From the workspace's last eval_dynamics and the motions of the same state; one entry a joint.
  const std::vector<JointReaction>& update(const Workspace& workspace, const std::vector<BodyMotion>& motions) noexcept;

  [[nodiscard]] const std::vector<JointReaction>& reactions() const { return reactions_; }

  /// Moment [N m] left over on the root body of each group of tied bodies: the driver's torque on a driven one, zero on
  /// a free one, the ground's on the frame. One entry a turn, after update().
  [[nodiscard]] const std::vector<double>& root_moments() const { return root_moments_; }

 private:
  struct Anchored {
    int body;
    Vec2 arm;  // from the centre of mass, in the body's axes
  };
  struct JointEnds {
    Anchored first;
    Anchored second;
  };
  struct LoadEnds {
    int first = -1;   // body that feels the opposite, or none
    Anchored second;  // where the force acts
  };
  struct TieStep {
    int joint;
    int outer;  // body whose moment is known once its own outer ties are
    int inner;
    bool outer_is_second;
  };

  void find_tie_steps();
  void add_force(int body, Vec2 at, Vec2 force) noexcept;
  void apply_joint_force(int joint, Vec2 force_on_second) noexcept;
  void apply_loads(const Workspace& workspace) noexcept;
  void apply_contacts(const Workspace& workspace) noexcept;
  void apply_closures(const Workspace& workspace) noexcept;
  void apply_driver_torques(const Workspace& workspace) noexcept;
  void sweep_tree() noexcept;
  void sweep_ties() noexcept;
  void remove_driver_forces(const Workspace& workspace) noexcept;

  const System* system_;
  const std::vector<BodyMotion>* motions_ = nullptr;
  std::vector<JointEnds> ends_;                    // one a joint
  std::vector<int> outward_;                       // bodies, children after parents
  std::vector<TieStep> tie_steps_;                 // outermost first
  std::vector<std::array<int, 2>> driven_angles_;  // one a driver of the tables: its body and the other; -1 for a slide
  std::vector<Anchored> contact_points_;           // one a contact: the centre of its circle
  std::vector<LoadEnds> load_ends_;                // one a load
  std::vector<Vec2> force_needed_;                 // one a body: what is still missing to its m a
  std::vector<double> moment_needed_;  // one a body: what is still missing to its I θ̈, about its centre of mass
  std::vector<JointReaction> reactions_;
  std::vector<double> root_moments_;
};

}  // namespace gudgeon
