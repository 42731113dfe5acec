// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Joint forces that balance each other without any load, and how much of them is left in.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "gudgeon/system/joint_sweep.h"

namespace gudgeon {

/// Every constraint that others imply leaves one state of self-stress open: forces in the joints that act on no body's
/// motion and no driver. Finds the shares of all of them that make the joint forces least: Σ F² + (M/ℓ)², with the
/// characteristic length ℓ. Holds its own memory.
class SelfStress {
 public:
  /// Keeps a reference.
  explicit SelfStress(const System& system);
  explicit SelfStress(const System&&) = delete;

  /// Whether any joint force is open.
  [[nodiscard]] bool empty() const { return states_.empty(); }
  /// Adds self-stress to reactions that balance all bodies, at the workspace's last evaluation and the motions of the
  /// same state.
  void relax(const Workspace& workspace, const std::vector<BodyMotion>& motions,
             std::vector<JointReaction>& reactions) noexcept;
  /// What self-stress leaves open of each joint's reaction in the worst case, for joint forces of order one: the
  /// largest force along x and y [N] and moment [N m/ℓ] of states that keep the side conditions.
  std::vector<JointReaction> find_openness(const Workspace& workspace, const std::vector<BodyMotion>& motions);

 private:
  // What is put under unit load: a row of a closure, a force in a joint within a rigid body, or a tie's moment.
  struct State {
    enum class Kind { row, pin, tie };
    Kind kind = Kind::row;
    int at = 0;   // closure or joint
    int row = 0;  // of a closure, or axis of a force
  };

  void find_states();
  void list_rows() noexcept;
  void apply(const State& state, const Workspace& workspace) noexcept;
  void apply_row(const State& state, const Workspace& workspace) noexcept;
  void find_conditions(const std::vector<BodyMotion>& motions) noexcept;
  void find_matrix(const Workspace& workspace, const std::vector<BodyMotion>& motions) noexcept;
  [[nodiscard]] double multiply(const std::vector<JointReaction>& a,
                                const std::vector<JointReaction>& b) const noexcept;
  [[nodiscard]] bool solve() noexcept;

  const System* system_;
  JointSweep sweep_;
  double length_;                                   // ℓ [m]
  std::vector<State> states_;                       // the rows first
  std::vector<int> pin_ties_;                       // joints that tie two angles and have no moment
  std::vector<int> driven_slides_;                  // joints
  std::vector<int> driver_rows_;                    // closures of drivers
  std::vector<double> row_forces_;                  // scratch of a solve
  std::vector<double> driver_moments_;              // of driver_rows_, of the state last applied
  std::vector<std::vector<JointReaction>> stress_;  // one a state
  Eigen::MatrixXd matrix_;                          // [Gram Eᵀ; E 0]
  Eigen::VectorXd right_;                           // after a solve the shares
  Eigen::VectorXd shares_;
  Eigen::VectorXd conditions_;
  Eigen::FullPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace gudgeon
