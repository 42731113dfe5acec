// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The forces between a journal and a surface of its bearing, both worn.
#pragma once

#include <optional>
#include <string_view>

#include "gudgeon/geometry/contact_surfaces.h"
#include "gudgeon/model/joint.h"
#include "gudgeon/system/coordinates.h"

namespace gudgeon {

/// A contact of a clearance joint compiled: its surfaces, its laws, and where its points and bodies are in the tables.
struct Contact {
  int joint = 0;            ///< index into Mechanism::joints
  int group = 0;            ///< index into Tables::contact_groups
  int bearing_surface = 0;  ///< which of the bearing's surfaces: 0, or for a slot 0 left and 1 right
  int journal_surface = 0;  ///< which of the journal's: 0, or for a block its corner
  Vec2 journal_center;      ///< [m] centre of the touching circle in the journal's body
  int bearing_row = 0;      ///< of the bearing's centre in the chain of points
  int journal_row = 0;
  int bearing_turn = 0;
  int journal_turn = 0;
  double bearing_offset = 0.0;  ///< body angle − turn angle [rad]
  double journal_offset = 0.0;
  int bearing_index = 0;  ///< equation of the bearing's turn
  int journal_index = 0;

  ContactSurfaces surfaces;
  double stiffness_factor = 0.0;  ///< 4/(3π(σ_i + σ_j)) [Pa], σ = (1 − ν²)/(πE)
  double contact_modulus = 0.0;   ///< E* [Pa], 1/E* = (1 − ν_i²)/E_i + (1 − ν_j²)/E_j
  double damping_factor = 0.0;    ///< χ [1] of the law of normal force
  double width = 0.0;             ///< w [m]
  AnyNormalForce normal_force;
  bool steps_at_onset = false;  ///< the normal force does
  AnyFriction friction;
  int bristle = -1;                ///< index of the bristle's deflection in the state, -1 without one
  double bristle_scale = 0.0;      ///< [m] deflection at which the bristle slips
  double slip_scale = 1.0;         ///< [m/s] the least slip over which the friction law changes
  double steepest_friction = 0.0;  ///< [s/m] largest dμ/dv of the friction law
  AnyWear bearing_wear;
  AnyWear journal_wear;
  double onset_speed_floor = 0.0;  ///< [m/s]
  NormalDirection normal_direction = NormalDirection::gap_gradient;
  PressureDistribution pressure = PressureDistribution::uniform;
  double sliding_distance = 0.0;  ///< [m] slid in the stages before this one, times the wear acceleration
};

/// What changes only at accepted events: whether the surfaces are taken to touch, and how fast they met.
struct ContactMode {
  bool in_contact = false;
  double onset_speed = 0.0;  ///< δ̇₀ [m/s]
};

/// Gap, forces and powers of one contact at one instant; all zero but the gap in free flight. Where the
/// surfaces of an active contact stand a hair apart, before they touch or once they part, its bristle has its rate
/// already, or still, and so has a force that begins with a step: within a step of the integrator neither jumps.
struct ContactForces {
  ContactGap gap;
  double slip_speed = 0.0;         ///< v [m/s] of the journal's surface relative to the bearing's, along perp(n)
  double normal_force = 0.0;       ///< F [N] >= 0
  double friction_force = 0.0;     ///< μ(v) F [N], of v's sign; acts on the journal along −perp(n)
  double bristle_rate = 0.0;       ///< ż [m/s] of the bristle, where the law has one
  double elastic_energy = 0.0;     ///< U [J]
  Vec2 force_on_journal{};         ///< [N] in the frame's axes, to be taken at the journal's centre
  double torque_on_bearing = 0.0;  ///< [N m] about the bearing's centre, beside −force_on_journal there
  double torque_on_journal = 0.0;  ///< [N m] about the journal's centre
  double damping_power = 0.0;      ///< [W] lost along the normal
  double friction_power = 0.0;     ///< [W] lost along the slip
  double surface_power = 0.0;      ///< [W] done by the surfaces where their force is not the gradient of U
};

/// Position and motion of the contact, from the motion of its two points and bodies.
inline RelativeMotion find_contact_motion(const Contact& contact, const Coordinates& coordinates, Vec2 bearing_position,
                                          Vec2 bearing_velocity, Vec2 journal_position,
                                          Vec2 journal_velocity) noexcept {
  return {journal_position - bearing_position,
          journal_velocity - bearing_velocity,
          coordinates.angle[contact.bearing_turn] + contact.bearing_offset,
          coordinates.angle[contact.journal_turn] + contact.journal_offset,
          coordinates.angle_rate[contact.bearing_turn],
          coordinates.angle_rate[contact.journal_turn]};
}

/// The forces of an active contact. Both bodies feel equal and opposite forces at one common point in the
/// middle of the overlap, so momentum and angular momentum are kept. Stiffness K = factor √R_r, eq. (35), with the
/// local worn radii. bristle z [m] is the deflection of the contact's bristle, where its friction law has one. Eqs. (6)
/// to (16) of the paper. forces.gap must be that of the motion; the rest is written.
void update_contact_forces(const Contact& contact, const RelativeMotion& motion, const ContactMode& mode,
                           double bristle, ContactForces& forces) noexcept;

inline ContactForces find_contact_forces(const Contact& contact, const RelativeMotion& motion, const ContactMode& mode,
                                         double bristle = 0.0) noexcept {
  ContactForces forces{.gap = find_gap(contact.surfaces, motion)};
  update_contact_forces(contact, motion, mode, bristle, forces);
  return forces;
}

/// How the forces of a contact answer to its motion.
struct ContactSlopes {
  double force_by_penetration = 0.0;  ///< ∂F/∂δ [N/m]
  double force_by_rate = 0.0;         ///< ∂F/∂δ̇ [N s/m]
  double coefficient = 0.0;           ///< μ [1] of v's sign
  double coefficient_by_slip = 0.0;   ///< dμ/dv [s/m]
};

/// By differences of the laws, at the forces that were last found for a contact that presses.
ContactSlopes find_contact_slopes(const Contact& contact, const ContactMode& mode, double bristle,
                                  const ContactForces& forces) noexcept;

/// Where the law of a contact ends, at the radii of its gap: nowhere for most.
struct NormalForceEnd {
  std::string_view law;
  std::string_view formula;  ///< in the law's own symbols
  LawEnd at;
};
std::optional<NormalForceEnd> find_normal_force_end(const Contact& contact, const ContactGap& gap) noexcept;

/// The least slip speed [m/s] over which a law changes: the smallest of its parameters that are speeds; 1 without any.
double find_slip_scale(const AnyFriction& friction);
/// The largest slope dμ/dv [s/m] that a law has between zero slip and the largest of its speeds; without its bristle.
double find_steepest_friction(const AnyFriction& friction);

/// Whether a law's force begins with a step as surfaces meet: its damping does not grow from nothing.
bool steps_at_onset(const AnyNormalForce& normal_force);
/// Whether a friction law has a bristle.
bool has_bristle(const AnyFriction& friction);
/// [m] the deflection at which a law's bristle slips, v z/(v − ż) at 1 m/s; zero without a bristle.
double find_bristle_scale(const AnyFriction& friction);

/// 4/(3π(σ_i + σ_j)) [Pa]: what eq. (8) multiplies the radii's root with.
double find_stiffness_factor(const Material& bearing, const Material& journal);
/// E* [Pa], 1/E* = (1 − ν_i²)/E_i + (1 − ν_j²)/E_j.
double find_contact_modulus(const Material& bearing, const Material& journal);

}  // namespace gudgeon
