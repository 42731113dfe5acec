// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reactions of all joints from what acts on the bodies, as one of many where constraints imply each other.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gudgeon/system/joint_sweep.h"

namespace gudgeon {

/// Loads, contacts, friction, closures and drivers act; the joints of the tree supply what m (a − g) and I θ̈ still lack
/// (docs/theory/dynamics.md, Eq. D14). Holds its own memory.
class ReactionSweep {
 public:
  /// Keeps references to mechanism and topology.
  ReactionSweep(const Mechanism& mechanism, const Topology& topology, const Tables& tables);

  /// From the workspace's last eval_dynamics and the motions of the same state; one entry a joint.
  const std::vector<JointReaction>& update(const Tables& tables, const Workspace& workspace,
                                           const std::vector<BodyMotion>& motions) noexcept;
  /// How they answer to friction alone, with the answers of accelerations, closures [n_solve] and efforts to it.
  const std::vector<JointReaction>& update_response(const Tables& tables, const Workspace& workspace,
                                                    std::span<const FrictionForces> friction,
                                                    std::span<const double> equations, std::span<const double> effort,
                                                    const std::vector<BodyMotion>& motions) noexcept;

  [[nodiscard]] std::vector<JointReaction>& reactions() { return sweep_.reactions(); }
  [[nodiscard]] const std::vector<JointReaction>& reactions() const { return sweep_.reactions(); }
  [[nodiscard]] const std::vector<double>& root_moments() const { return sweep_.root_moments(); }

 private:
  struct LoadEnds {
    int first = -1;   // body that feels the opposite, or none
    Anchored second;  // where the force acts
  };

  void find_load_ends(const Mechanism& mechanism);
  void apply_loads(const Workspace& workspace) noexcept;
  void apply_contacts(const Tables& tables, const Workspace& workspace) noexcept;
  void apply_friction(const Tables& tables, std::span<const FrictionForces> friction) noexcept;
  void add_friction_reactions(const Tables& tables, std::span<const FrictionForces> friction) noexcept;
  void apply_closures(const Tables& tables, const Workspace& workspace, std::span<const double> equations) noexcept;
  void apply_driver_torques(std::span<const double> effort) noexcept;
  void remove_driver_forces(std::span<const double> effort, const std::vector<BodyMotion>& motions) noexcept;
  void finish(const Tables& tables, const Workspace& workspace, std::span<const FrictionForces> friction,
              std::span<const double> equations, std::span<const double> effort,
              const std::vector<BodyMotion>& motions) noexcept;

  const Mechanism* mechanism_;
  const Topology* topology_;
  JointSweep sweep_;
  std::vector<std::array<int, 2>> driven_angles_;  // one a driver of the tables: its body and the other; -1 for a slide
  std::vector<Anchored> contact_points_;           // one a contact: the centre of its circle
  std::vector<LoadEnds> load_ends_;                // one a load
};

}  // namespace gudgeon
