// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Full motion of all bodies from a solved state, and the energies that follow from it.
#pragma once

#include <vector>

#include "gudgeon/system/system.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Motion of one body's centre of mass and of its angle.
struct BodyMotion {
  Vec2 position;                    ///< [m]
  Vec2 velocity;                    ///< [m/s]
  Vec2 acceleration;                ///< [m/s^2]
  double angle = 0.0;               ///< [rad]
  double angle_rate = 0.0;          ///< [rad/s]
  double angle_acceleration = 0.0;  ///< [rad/s^2]
};

/// Finds the motion of all bodies; compiled once, holds its own scratch memory.
class BodyMotionFinder {
 public:
  /// Keeps a reference.
  explicit BodyMotionFinder(const System& system) : BodyMotionFinder(system.mechanism, system.topology) {}
  explicit BodyMotionFinder(const System&&) = delete;
  BodyMotionFinder(const Mechanism& mechanism, const Topology& topology);

  /// From the workspace's last eval_dynamics; one entry a body, the frame's first.
  const std::vector<BodyMotion>& update(const Workspace& workspace) noexcept;
  /// How accelerations answer to those of the free coordinates [n_free] alone, drivers keeping theirs; at coordinates
  /// whose rates are zero.
  const std::vector<BodyMotion>& update_response(const Coordinates& at_rest, const double* accelerations) noexcept;
  [[nodiscard]] const std::vector<BodyMotion>& motions() const { return motions_; }

 private:
  void take_free_accelerations(const double* accelerations) noexcept;
  void find_motions(const Coordinates& coordinates) noexcept;

  const Topology* topology_;
  PointChain chain_;
  std::vector<int> rows_;  // of each body's centre of mass
  std::vector<PointChain::PointMotion> points_;
  std::vector<Vec2> accelerations_;
  std::vector<double> angle_accelerations_;  // one a turn; the frame's stays zero
  std::vector<double> slide_accelerations_;
  std::vector<BodyMotion> motions_;
};

/// Kinetic energy [J] of all bodies: ½ m v² + ½ I θ̇².
double find_kinetic_energy(const Mechanism& mechanism, const std::vector<BodyMotion>& motions) noexcept;
/// The same as ½ vᵀHv, from coordinates and rates alone: less work by far.
double find_kinetic_energy(const Tables& tables, const Coordinates& coordinates) noexcept;

/// Potential energy [J] of gravity, constant forces and torques, relative to the frame's origin and zero angles.
double find_potential_energy(const Tables& tables, const Coordinates& coordinates) noexcept;
/// The same and the energy stored in springs, torsion springs and bushings, from the last evaluation.
double find_potential_energy(const Tables& tables, const Workspace& workspace) noexcept;

/// Energy [J] stored in all contacts, from the last evaluation.
double find_elastic_energy(const Workspace& workspace) noexcept;

}  // namespace gudgeon
