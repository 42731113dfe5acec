// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Axes of bearings and slots, and sums over contacts.
#include "gudgeon/sim/clearance_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gudgeon/system/dynamics.h"

namespace gudgeon {

ClearanceReader::ClearanceReader(const System& system, std::size_t group)
    : tables_(&system.tables), group_(system.tables.contact_groups[group]) {
  const Mechanism& mechanism = system.mechanism;
  const AnyJoint& kind = mechanism.joints[group_.joint].kind;
  const auto find_arm = [&](const Anchor& anchor) {
    const int index = find_body(mechanism, anchor.body);
    const Body& body = mechanism.bodies[index];
    return Arm{index, find_point(body, anchor.point)->position - body.center_of_mass};
  };
  const auto [bearing, journal] = anchors(kind);
  bearing_ = find_arm(bearing);
  journal_ = find_arm(journal);
  if (const auto* guide = std::get_if<PrismaticClearance>(&kind)) {
    is_slot_ = true;
    direction_ = guide->direction;
    relative_angle_ = guide->relative_angle;
  } else if (const auto* slot = std::get_if<PinInSlotClearance>(&kind)) {
    is_slot_ = true;
    direction_ = slot->direction;
  }
}

void ClearanceReader::read_motion(const Workspace& workspace, const std::vector<BodyMotion>& motions,
                                  ClearanceReading& reading) const {
  if (is_slot_) return read_slot(motions, reading);
  const Contact& contact = tables_->contacts[group_.first_contact];
  const RelativeMotion motion = find_contact_motion(contact, workspace);
  const Vec2 normal = find_gap(contact.surfaces, motion).normal;
  reading.offset = motion.offset;
  reading.offset_rate = motion.velocity;
  reading.contact_angle = std::remainder(std::atan2(normal.y, normal.x) - motion.bearing_angle, 2.0 * std::numbers::pi);
}

void ClearanceReader::read_slot(const std::vector<BodyMotion>& motions, ClearanceReading& reading) const {
  const BodyMotion& bearing = motions[bearing_.body];
  const BodyMotion& journal = motions[journal_.body];
  const Vec2 bearing_arm = make_rotation(bearing.angle) * bearing_.local;
  const Vec2 journal_arm = make_rotation(journal.angle) * journal_.local;
  reading.offset = journal.position + journal_arm - bearing.position - bearing_arm;
  reading.offset_rate = journal.velocity + journal.angle_rate * perp(journal_arm) - bearing.velocity -
                        bearing.angle_rate * perp(bearing_arm);
  // Rates as seen from the bearing's body.
  const Rotation turned = make_rotation(bearing.angle + direction_);
  const Vec2 along{turned.c, turned.s};
  const Vec2 rate = reading.offset_rate - bearing.angle_rate * perp(reading.offset);
  reading.displacement = dot(along, reading.offset);
  reading.speed = dot(along, rate);
  reading.height = dot(perp(along), reading.offset);
  reading.height_rate = dot(perp(along), rate);
  reading.tilt = std::remainder(journal.angle - bearing.angle - relative_angle_, 2.0 * std::numbers::pi);
  reading.tilt_rate = journal.angle_rate - bearing.angle_rate;
}

void ClearanceReader::read_forces(const Workspace& workspace, std::span<const double> penetrations,
                                  ClearanceReading& reading) const {
  reading.n_contacts = 0;
  reading.penetration = -std::numeric_limits<double>::infinity();
  reading.normal_force = reading.left_force = reading.right_force = 0.0;
  reading.friction_force = reading.slip_speed = reading.bristle = 0.0;
  double most = 0.0;
  for (int k = group_.first_contact; k < group_.end_contact; ++k) {
    const ContactForces& forces = workspace.contact_forces[k];
    // perp(n) is along the slot on its right side, against it on the left.
    const bool left = tables_->contacts[k].bearing_surface == 0;
    const double sign = is_slot_ && left ? -1.0 : 1.0;
    if (forces.normal_force > 0.0) ++reading.n_contacts;
    reading.penetration = std::max(reading.penetration, penetrations[static_cast<std::size_t>(k)]);
    reading.normal_force += forces.normal_force;
    (left ? reading.left_force : reading.right_force) += forces.normal_force;
    reading.friction_force += sign * forces.friction_force;
    if (forces.normal_force < most) continue;
    most = forces.normal_force;
    reading.slip_speed = sign * forces.slip_speed;
    const int bristle = tables_->contacts[k].bristle;
    if (bristle >= 0) reading.bristle = sign * workspace.bristles[bristle];
  }
}

}  // namespace gudgeon
