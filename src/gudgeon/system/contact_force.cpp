// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Normal force, friction and their powers.
#include "gudgeon/system/contact_force.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/system/coordinates.h"

namespace gudgeon {

double find_stiffness_factor(const Material& bearing, const Material& journal) {
  // π σ = (1 − ν²)/E, so that π cancels against the one in the formula.
  const auto compliance = [](const Material& m) { return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus; };
  return 4.0 / (3.0 * (compliance(bearing) + compliance(journal)));
}

RevoluteMotion find_contact_motion(const Contact& contact, const Coordinates& coordinates, Vec2 bearing_position,
                                   Vec2 bearing_velocity, Vec2 journal_position, Vec2 journal_velocity) noexcept {
  return {journal_position - bearing_position,
          journal_velocity - bearing_velocity,
          coordinates.angle[contact.bearing_turn] + contact.bearing_offset,
          coordinates.angle[contact.journal_turn] + contact.journal_offset,
          coordinates.angle_rate[contact.bearing_turn],
          coordinates.angle_rate[contact.journal_turn]};
}

ContactForces find_contact_forces(const Contact& contact, const RevoluteMotion& motion,
                                  const ContactLatch& latch) noexcept {
  ContactForces forces;
  forces.gap = find_revolute_gap(contact.surfaces, motion);
  const RevoluteGap& gap = forces.gap;
  if (!latch.in_contact || gap.penetration <= 0.0) return forces;  // NaN goes on, to be seen

  // Along the normal.
  const double clearance = gap.bearing_radius - gap.journal_radius;
  const double stiffness = contact.stiffness_factor * std::sqrt(gap.bearing_radius * gap.journal_radius / clearance);
  const NormalContact kinematics{gap.penetration, gap.penetration_rate,
                                 std::max(latch.onset_speed, contact.onset_speed_floor), stiffness};
  const NormalForce normal = std::visit([&](const auto& law) { return law(kinematics); }, contact.normal_force);
  forces.normal_force = normal.force;
  forces.elastic_energy = normal.elastic_energy;
  forces.damping_power = (normal.force - normal.elastic_force) * gap.penetration_rate;

  // Along the slip, at the middle of the overlap.
  const Vec2 tangent = perp(gap.normal);
  const double journal_lever = gap.journal_radius - 0.5 * gap.penetration;
  const double bearing_lever = gap.eccentricity + journal_lever;
  forces.slip_speed =
      dot(tangent, motion.velocity) + motion.journal_rate * journal_lever - motion.bearing_rate * bearing_lever;
  const double friction_coefficient =
      std::visit([&](const auto& law) { return law(forces.slip_speed); }, contact.friction);
  forces.friction_force = friction_coefficient * normal.force;
  forces.friction_power = forces.friction_force * forces.slip_speed;

  double across = -forces.friction_force;
  forces.torque_on_journal = -forces.friction_force * journal_lever;
  forces.torque_on_bearing = forces.friction_force * bearing_lever;
  if (contact.surfaces.is_worn()) {
    // Of a worn surface, dlnK/dt = ½ [Ṙ_i/R_i + Ṙ_j/R_j − (Ṙ_i − Ṙ_j)/c]: energy stored at one place of the surface is
    // given back at another with another stiffness.
    const double radius_rate = gap.bearing_radius_rate - gap.journal_radius_rate;
    forces.surface_power = 0.5 * normal.elastic_energy *
                           (gap.bearing_radius_rate / gap.bearing_radius +
                            gap.journal_radius_rate / gap.journal_radius - radius_rate / clearance);
    if (contact.normal_direction == NormalDirection::gap_gradient) {
      // −F ∂δ/∂r and −F ∂δ/∂θ of δ = e − R_i(φ − θ_i) + R_j(φ − θ_j).
      across += normal.force * (gap.bearing_slope - gap.journal_slope) / gap.eccentricity;
      forces.torque_on_bearing -= normal.force * gap.bearing_slope;
      forces.torque_on_journal += normal.force * gap.journal_slope;
    } else {
      forces.surface_power -= normal.force * radius_rate;  // ė − δ̇
    }
  }
  forces.force_on_journal = -normal.force * gap.normal + across * tangent;
  return forces;
}

}  // namespace gudgeon
