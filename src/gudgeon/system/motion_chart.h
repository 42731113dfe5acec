// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A mechanism near one position, in as many numbers as it has degrees of freedom.
#pragma once

#include <Eigen/Dense>
#include <string>

#include "gudgeon/system/system.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// [m] The longest distance of a point or a centre of mass from its body's origin; 1 without any.
double find_longest_arm(const Mechanism& mechanism);

/// The body or guide whose angle or displacement a free coordinate is.
std::string name_coordinate(const System& system, Eigen::Index coordinate);

/// With x the free coordinates (slides as shares of the mechanism's size) and Z an orthonormal basis of the directions
/// that keep the loops closed at x₀: y = Zᵀ (x − x₀). Every y near zero is one position, and ÿ = Zᵀ ẍ.
class MotionChart {
 public:
  /// Around a position whose loops are closed. Keeps a reference to the system; drivers stay where they are at t = 0.
  MotionChart(const System& system, const Eigen::VectorXd& q);
  MotionChart(const System&&, const Eigen::VectorXd&) = delete;

  [[nodiscard]] Eigen::Index size() const { return basis_.cols(); }
  /// Z, a row a free coordinate.
  [[nodiscard]] const Eigen::MatrixXd& basis() const { return basis_; }
  [[nodiscard]] Workspace& workspace() { return workspace_; }
  /// The free coordinates [rad, m] of the last move.
  [[nodiscard]] const Eigen::VectorXd& q() const { return q_; }

  /// Goes to y; false when the loops cannot be closed there.
  bool move_to(const Eigen::VectorXd& y);
  /// ẍ of the free coordinates [1/s^2] of the last acceleration found, slides as shares of the size.
  [[nodiscard]] const Eigen::VectorXd& accelerations() const { return accelerations_; }
  /// ÿ at the place of the last move, for the rates ẏ.
  Eigen::VectorXd find_acceleration(const Eigen::VectorXd& rates);

 private:
  void update();
  [[nodiscard]] Eigen::MatrixXd find_matrix() const;

  const System* system_;
  Workspace workspace_;
  Eigen::VectorXd scale_;  // of each free coordinate: 1 rad, or the mechanism's size [m]
  Eigen::VectorXd start_;
  Eigen::VectorXd q_;
  Eigen::VectorXd v_;
  Eigen::VectorXd accelerations_;
  Eigen::MatrixXd basis_;
  double size_ = 0.0;  // [m]
};

}  // namespace gudgeon
