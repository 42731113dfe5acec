// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The textbook form of a mechanism, as an oracle for the engine: maximal coordinates (centre of mass and angle of
// every body), every joint a few constraint rows, one dense system [M Φqᵀ; Φq 0][q̈; λ] = [Q; γ]. Slow and plain; it
// reads the description anew at every evaluation and shares nothing with the engine but the laws.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "gudgeon/model/mechanism.h"

namespace gudgeon::oracle {

/// One body's motion; the frame's is all zero.
struct TextbookBody {
  Vec2 center;              ///< [m] centre of mass in the frame (for the frame: its origin)
  double angle = 0.0;       ///< θ [rad]
  Vec2 velocity;            ///< [m/s] of the centre of mass
  double angle_rate = 0.0;  ///< θ̇ [rad/s]
};

/// What one contact of a clearance joint remembers.
struct TextbookContact {
  bool in_contact = false;
  double onset_speed = 0.0;  ///< δ̇₀ [m/s]
};

struct TextbookState {
  std::vector<TextbookBody> bodies;       ///< one a body in the mechanism's order, frame first
  std::vector<TextbookContact> contacts;  ///< those of every clearance joint in the order of the joints
};

/// Constraint rows of all joints in their order (2 a revolute or prismatic joint, 3 a rigid one, 1 a pin in a slot),
/// then of all drivers.
struct TextbookRows {
  Eigen::VectorXd residual;   ///< Φ(q, t)
  Eigen::VectorXd rate;       ///< Φ̇ = Φq q̇ + Φt
  Eigen::VectorXd time_rate;  ///< Φt
  Eigen::VectorXd gamma;      ///< γ: Φ̈ = 0 is Φq q̈ = γ
  Eigen::MatrixXd jacobian;   ///< Φq, columns x, y, θ of every body; the first three are the frame's
};

struct TextbookPoint {
  int body = 0;
  Vec2 arm;       ///< [m] from the centre of mass, in the frame's axes
  Vec2 position;  ///< [m]
  Vec2 velocity;  ///< [m/s]
};

struct TextbookAcceleration {
  Vec2 center;         ///< [m/s^2] of the centre of mass
  double angle = 0.0;  ///< θ̈ [rad/s^2]
};

/// What a joint does to its second body (for a clearance joint: the journal's), in the frame's axes. A slide driver's
/// force is not in its joint's reaction.
struct TextbookReaction {
  Vec2 force;           ///< [N]
  double moment = 0.0;  ///< [N m] about the second anchor point
};

/// Contact of unworn surfaces; force members are zero unless in contact and δ > 0.
struct TextbookContactForce {
  int joint = 0;
  Vec2 normal;  ///< n, from the bearing's centre to the journal's (zero when they coincide), or out of a slot
  double penetration = 0.0;       ///< δ = |e| − c [m]
  double penetration_rate = 0.0;  ///< δ̇ [m/s]
  double stiffness = 0.0;         ///< K [N/m^n]
  Vec2 point;                     ///< Q [m], the middle of the overlap
  double slip_speed = 0.0;        ///< v [m/s] of the journal against the bearing at Q, along t = perp(n)
  double normal_force = 0.0;      ///< F [N], −F n on the journal
  double friction_force = 0.0;    ///< [N] on the journal along t
  double elastic_energy = 0.0;    ///< [J]
  Vec2 force;                     ///< [N] on the journal at Q: −F n + friction t
};

/// A force at a place and a moment beside it, on one body.
struct TextbookAction {
  int body = 0;
  Vec2 at;              ///< [m]
  Vec2 force;           ///< [N]
  double moment = 0.0;  ///< [N m]
};

/// What all loads but the constant ones do.
struct TextbookLoads {
  std::vector<TextbookAction> actions;
  double stored_energy = 0.0;  ///< [J] in springs
  double work_power = 0.0;     ///< [W] of variable forces and torques
  double damper_power = 0.0;   ///< [W] lost
};

struct TextbookSolution {
  std::vector<TextbookAcceleration> accelerations;  ///< one a body, frame first
  Eigen::VectorXd multipliers;                      ///< λ, in the order of the rows
  std::vector<TextbookReaction> reactions;          ///< one a joint
  std::vector<double> efforts;                      ///< one a driver: [N m] or [N] delivered, positive along its value
  std::vector<TextbookContactForce> contacts;       ///< in the order of the state's
  TextbookLoads loads;
  int n_redundant_rows = 0;  ///< if not zero, λ and reactions are one choice among many
};

struct TextbookEnergy {
  double kinetic = 0.0;    ///< [J]
  double potential = 0.0;  ///< [J] of gravity, constant loads and springs
  double elastic = 0.0;    ///< [J] of the contacts
  [[nodiscard]] double total() const { return kinetic + potential + elastic; }
};

/// Constraint rows of a joint: none for a clearance.
int n_rows(const AnyJoint& joint);

class Textbook {
 public:
  explicit Textbook(Mechanism mechanism);
  [[nodiscard]] const Mechanism& mechanism() const { return mechanism_; }

  /// A state with every body at the frame's origin, at rest, and no contact.
  [[nodiscard]] TextbookState make_state() const;
  /// A body placed by its origin rather than its centre of mass.
  [[nodiscard]] TextbookBody place(int body, Vec2 origin, double angle, Vec2 origin_velocity, double angle_rate) const;

  [[nodiscard]] TextbookPoint eval_point(const TextbookState& state, const Anchor& anchor) const;
  [[nodiscard]] TextbookRows eval_rows(const TextbookState& state, double time) const;
  [[nodiscard]] std::vector<TextbookContactForce> eval_contacts(const TextbookState& state) const;
  [[nodiscard]] TextbookEnergy eval_energy(const TextbookState& state) const;
  [[nodiscard]] TextbookSolution solve(const TextbookState& state, double time) const;
  /// One step of the classical fourth-order Runge-Kutta method; contact modes stay.
  [[nodiscard]] TextbookState step_rk4(const TextbookState& state, double time, double step) const;

 private:
  [[nodiscard]] Eigen::VectorXd eval_applied(const TextbookState& state,
                                             const std::vector<TextbookContactForce>& contacts,
                                             const TextbookLoads& loads) const;
  [[nodiscard]] Eigen::VectorXd make_masses() const;
  void find_reactions(const TextbookState& state, const TextbookRows& rows, TextbookSolution& solution) const;

  Mechanism mechanism_;
};

}  // namespace gudgeon::oracle
