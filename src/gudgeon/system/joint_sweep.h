// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Forces handed from body to body along the tree.
#pragma once

#include <vector>

#include "gudgeon/system/body_motion.h"

namespace gudgeon {

/// What a joint does to its second body (the journal's, for a clearance joint), in the frame's axes.
struct JointReaction {
  Vec2 force;           ///< [N] at the second anchor
  double moment = 0.0;  ///< [N m] about it; a revolute joint or a pin in a slot has none but friction's
};

/// A point of a body, from its centre of mass and in its axes.
struct Anchored {
  int body = 0;
  Vec2 arm;
};

/// One backward Newton-Euler sweep: the joints of the tree supply what every body still needs. Holds its own memory.
class JointSweep {
 public:
  /// Keeps a reference.
  explicit JointSweep(const System& system) : JointSweep(system.mechanism, system.topology) {}
  explicit JointSweep(const System&&) = delete;
  JointSweep(const Mechanism& mechanism, const Topology& topology);

  /// Begins with bodies that need nothing and joints that do nothing, where the bodies are.
  void begin(const std::vector<BodyMotion>& motions) noexcept;
  /// Lets a body need so much more.
  void need(int body, Vec2 force, double moment) noexcept;
  /// Gives a body a force at a place [m].
  void add_force(int body, Vec2 at, Vec2 force) noexcept;
  void add_torque(int body, double torque) noexcept { moment_needed_[body] -= torque; }
  /// Both bodies of a joint feel its force, at its second point.
  void apply_joint_force(int joint, Vec2 force_on_second) noexcept;
  void apply_joint_moment(int joint, double moment_on_second) noexcept;
  /// Adds to a joint's reaction alone.
  void add_reaction(int joint, Vec2 force, double moment) noexcept;
  /// From the leaves to the frame.
  void finish() noexcept;

  /// A vector of a body's axes in the frame's.
  [[nodiscard]] Vec2 turn(int body, Vec2 vector) const noexcept {
    return make_rotation((*motions_)[body].angle) * vector;
  }
  [[nodiscard]] Vec2 find_place(const Anchored& anchored) const noexcept;
  [[nodiscard]] const Anchored& first(int joint) const { return ends_[joint].first; }
  [[nodiscard]] const Anchored& second(int joint) const { return ends_[joint].second; }
  /// One a joint. A joint that ties two angles has the moment that its tied bodies need.
  [[nodiscard]] std::vector<JointReaction>& reactions() { return reactions_; }
  [[nodiscard]] const std::vector<JointReaction>& reactions() const { return reactions_; }
  /// What is left over on the root body of each group of tied bodies, one a turn.
  [[nodiscard]] const std::vector<double>& root_moments() const { return root_moments_; }

 private:
  struct Ends {
    Anchored first;
    Anchored second;
  };
  struct TieStep {
    int joint;
    int outer;  // body whose moment is known once its own outer ties are
    int inner;
    bool outer_is_second;
  };

  void find_tie_steps(const Mechanism& mechanism);
  void sweep_tree() noexcept;
  void sweep_ties() noexcept;

  const Topology* topology_;
  const std::vector<BodyMotion>* motions_ = nullptr;
  std::vector<Ends> ends_;             // one a joint
  std::vector<int> outward_;           // bodies, children after parents
  std::vector<TieStep> tie_steps_;     // outermost first
  std::vector<Vec2> force_needed_;     // one a body: what is still missing to its m a
  std::vector<double> moment_needed_;  // one a body: what is still missing to its I θ̈, about its centre of mass
  std::vector<JointReaction> reactions_;
  std::vector<double> root_moments_;
};

}  // namespace gudgeon
