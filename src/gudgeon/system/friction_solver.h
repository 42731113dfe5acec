// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Friction of ideal joints: reactions depend on friction and friction on reactions (docs/theory/friction.md, Eq. F14).
#pragma once

#include <Eigen/LU>
#include <array>
#include <memory>
#include <vector>

#include "gudgeon/system/reaction_sweep.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Finds all joints' friction at one state and adds it to a solution without friction. Reactions are affine in
/// friction, ρ = ρ₀ + C a; the laws make a = A(ρ). Holds its own memory.
class FrictionSolver {
 public:
  /// Of tables that have joints with friction.
  explicit FrictionSolver(const Tables& tables);

  /// Corrects accelerations, closures and efforts of the workspace's evaluation, and writes its forces and its margin.
  /// Where friction has no solution, or more than one, the margin is zero or less and the solution no number.
  void solve(const Tables& tables, Workspace& workspace) noexcept;

 private:
  // What the laws say at the slip of one joint; of a slot, at that of either wall.
  struct Slip {
    Vec2 along;                            // the line, in the frame's axes
    double turning = 0.0;                  // [rad/s] of the second body against the first
    std::array<double, 2> speed{};         // [m/s]
    std::array<double, 2> coefficient{};   // μ [1]
    std::array<double, 2> bristle_rate{};  // [m/s]
    [[nodiscard]] Vec2 across() const { return perp(along); }
  };
  using Components = std::array<double, 2>;  // of a reaction: F_x, F_y of a pin; N, M of a guide; N of a slot

  bool find_slips(const Tables& tables, Workspace& workspace) noexcept;
  void find_base(const Tables& tables, Workspace& workspace) noexcept;
  void find_responses(const Tables& tables, Workspace& workspace) noexcept;
  void find_response(const Tables& tables, Workspace& workspace, std::size_t joint, int action) noexcept;
  [[nodiscard]] Components find_components(std::size_t joint, const JointReaction& reaction) const noexcept;
  [[nodiscard]] FrictionPair make_pair(std::size_t joint, const double* action) const noexcept;
  bool find_actions(double share) noexcept;
  bool follow_actions() noexcept;
  void eval_laws(double share) noexcept;
  void eval_law(std::size_t joint, double share) noexcept;
  void factor() noexcept;
  [[nodiscard]] double find_error() const noexcept;
  void find_margin(Workspace& workspace) noexcept;
  [[nodiscard]] double find_least_ratio(std::size_t joint) const noexcept;
  void add_solution(const Tables& tables, Workspace& workspace) noexcept;
  void write_forces(const Tables& tables, Workspace& workspace) noexcept;

  std::shared_ptr<const FrictionBodies> bodies_;
  std::vector<FrictionJoint> joints_;
  BodyMotionFinder motions_;
  ReactionSweep sweep_;
  Coordinates at_rest_;
  std::vector<Slip> slips_;                    // one a joint
  std::vector<FrictionForces> unit_;           // one a joint: of one action alone
  std::vector<std::vector<double>> response_;  // one an action: all equations' answer to it
  std::vector<double> effort_;                 // the drivers' answer to one
  std::vector<Vec2> loads_;                    // one a row of the chain of points
  Eigen::VectorXd base_;                       // ρ₀, two components a joint
  Eigen::MatrixXd effect_;                     // C
  Eigen::VectorXd components_;                 // ρ
  Eigen::VectorXd action_;                     // a
  Eigen::VectorXd trial_;
  Eigen::VectorXd law_;       // A
  Eigen::MatrixXd gradient_;  // of each action by the two components of its joint
  Eigen::VectorXd scale_;     // what rounding of each action is measured by
  Eigen::VectorXd step_;
  Eigen::MatrixXd matrix_;  // I − A′ C
  Eigen::MatrixXd inverse_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace gudgeon
