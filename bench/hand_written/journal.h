// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A journal in an unworn bearing, Lankarani-Nikravesh with n = 1.5 and any friction curve, nothing but the force.
#pragma once

#include <algorithm>
#include <cmath>

#include "gudgeon/base/vec2.h"
#include "gudgeon/system/contact_force.h"

namespace gudgeon::hand_written {

struct JournalMotion {
  Vec2 offset;          ///< [m] journal's centre minus bearing's
  Vec2 velocity;        ///< [m/s]
  double bearing_rate;  ///< [rad/s]
  double journal_rate;
};

struct JournalContact {
  double journal_radius;  ///< [m]
  double clearance;       ///< [m]
  double stiffness;       ///< K [N/m^1.5]
  double damping;         ///< χ [1]
};

struct JournalForce {
  Vec2 force;                   ///< [N] on the journal, at its centre
  double journal_torque = 0.0;  ///< [N m]
  double bearing_torque = 0.0;
};

inline constexpr double kOnsetSpeedFloor = 1e-3;  // [m/s], the default of ContactProperties

template <class Friction>
JournalForce find_journal_force(const JournalMotion& motion, const ContactMode& mode, const JournalContact& contact,
                                Friction&& friction) noexcept {
  if (!mode.in_contact) return {};
  const double eccentricity = norm(motion.offset);
  const double penetration = eccentricity - contact.clearance;
  if (penetration <= 0.0) return {};
  const Vec2 n = (1.0 / eccentricity) * motion.offset;
  const double onset_speed = std::max(mode.onset_speed, kOnsetSpeedFloor);
  const double force = std::max(contact.stiffness * penetration * std::sqrt(penetration) *
                                    (1.0 + contact.damping * dot(n, motion.velocity) / onset_speed),
                                0.0);
  const double journal_lever = contact.journal_radius - 0.5 * penetration;
  const double bearing_lever = eccentricity + journal_lever;
  const double slip =
      cross(n, motion.velocity) + motion.journal_rate * journal_lever - motion.bearing_rate * bearing_lever;
  const double drag = friction(slip) * force;
  return {-force * n - drag * perp(n), -drag * journal_lever, drag * bearing_lever};
}

}  // namespace gudgeon::hand_written
