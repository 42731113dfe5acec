// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The textbook form as one would write it to be fast: maximal coordinates (centre of mass and angle of every body),
// [M Φqᵀ; Φq 0] [q̈; λ] = [Q; γ − 2 α Φ̇ − β² Φ], every name resolved beforehand and only the changing entries of the
// matrix written anew. Contacts go through the engine's own laws, so that a comparison is one of the equations alone.
#pragma once

#include <span>
#include <vector>

#include "bench/textbook/saddle_solver.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/system.h"

namespace gudgeon::textbook {

/// A point of a body by its arm from the centre of mass, in the body's axes; body 0 is the frame.
struct BodyPoint {
  int body = 0;
  Vec2 arm;  ///< [m]
};

/// Constraint rows of one joint or driver, the value a driver asks for being start + speed t.
struct Constraint {
  enum class Kind {
    point,  ///< r₂ − r₁, two rows
    line,   ///< e·(r₂ − r₁) − value, e turning with the first body
    angle,  ///< θ₂ − θ₁ − value
  };
  Kind kind = Kind::point;
  BodyPoint first;
  BodyPoint second;
  double direction = 0.0;  ///< [rad] of e in the first body's axes
  double start = 0.0;      ///< [rad] or [m]
  double speed = 0.0;      ///< [rad/s] or [m/s]
};

/// A gap as an integrator watches it.
struct GapSample {
  double penetration = 0.0;       ///< [m]
  double penetration_rate = 0.0;  ///< [m/s]
};

/// y = [x, y, θ of every moving body | their rates | bristles | work], the last one [J] what drivers have put in less
/// what contacts have lost.
class MaximalForm {
 public:
  /// Takes mechanisms of ideal joints, revolute clearances, uniform drivers and constant loads; throws
  /// std::invalid_argument for any other.
  MaximalForm(const Mechanism& mechanism, Feedback feedback, SaddleSolver::Kind solver);

  [[nodiscard]] std::size_t n_coordinates() const { return 3 * static_cast<std::size_t>(n_bodies_); }
  [[nodiscard]] std::size_t n_states() const { return 2 * n_coordinates() + n_bristles_; }
  [[nodiscard]] std::size_t size() const { return n_states() + 1; }

  /// The state in which bodies stand and move as the poses of their origins say, frame first.
  [[nodiscard]] std::vector<double> make_state(std::span<const BodyPose> poses) const;

  /// No allocation with the dense solver.
  void eval(double t, const double* y, double* slope);
  void find_gaps(double t, const double* y, std::span<GapSample> gaps);
  /// Kinetic, potential and elastic energy [J].
  [[nodiscard]] double find_energy(double t, const double* y);

  std::vector<ContactMode> contact_modes;
  std::vector<ContactForces> contact_forces;  ///< of the last evaluation

 private:
  struct PointMotion {
    Vec2 arm;
    Vec2 position;
    Vec2 velocity;
  };
  struct ContactPair {
    Contact contact;
    BodyPoint bearing;
    BodyPoint journal;
  };
  struct PointForce {
    BodyPoint point;
    Vec2 force;
  };

  void add_joint(const AnyJoint& joint);
  void add_driver(const Driver& driver);
  void add_load(const AnyLoad& load);
  void number_entries(SaddleSolver::Kind solver);

  void move_bodies(const double* y);
  [[nodiscard]] PointMotion find_point(const BodyPoint& point) const;
  [[nodiscard]] RelativeMotion find_relative_motion(const ContactPair& pair) const;
  void write_point(const Constraint& constraint, int row);
  void write_line(const Constraint& constraint, double t, int row);
  void write_angle(const Constraint& constraint, double t, int row);
  void put(double value);
  void add_forces(const double* bristles);
  void push(int body, Vec2 arm, Vec2 force, double torque);

  const Mechanism mechanism_;
  Feedback feedback_;
  int n_bodies_ = 0;  // that move
  std::size_t n_bristles_ = 0;
  std::vector<Constraint> constraints_;
  std::vector<int> driver_rows_;
  std::vector<double> driver_speeds_;
  std::vector<ContactPair> pairs_;
  std::vector<PointForce> forces_;
  std::vector<double> constant_load_;  // gravity and torques, one an equation

  std::vector<Vec2> center_;  // one a body, frame first
  std::vector<Vec2> velocity_;
  std::vector<double> angle_;
  std::vector<double> angle_rate_;
  std::vector<Rotation> rotation_;
  SaddleSolver solver_;
  std::size_t cursor_ = 0;  // next entry to be written
};

}  // namespace gudgeon::textbook
