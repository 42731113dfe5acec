// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where a journal stands in its bearing, and how deep the two surfaces would overlap.
#pragma once

#include "gudgeon/geometry/contact_gap.h"
#include "gudgeon/geometry/radial_profile.h"

namespace gudgeon {

/// The two surfaces of a revolute clearance joint, each worn in its own body.
struct RevoluteSurfaces {
  double bearing_radius = 0.0;  ///< R_i [m], unworn
  double journal_radius = 0.0;  ///< R_j [m], unworn
  RadialProfile bearing_wear;   ///< a bearing grows by its depth
  RadialProfile journal_wear;   ///< a journal shrinks by its depth

  /// Smallest clearance [m] that any direction can have.
  [[nodiscard]] double least_clearance() const {
    return bearing_radius - journal_radius + bearing_wear.least_depth() + journal_wear.least_depth();
  }
  [[nodiscard]] bool is_worn() const { return bearing_wear.is_worn() || journal_wear.is_worn(); }
};

/// Where the centres are from each other.
struct CentreLine {
  double eccentricity = 0.0;  ///< e [m]
  double direction = 0.0;     ///< angle of n in the frame [rad]; only set for worn surfaces
};

/// The gap of a revolute clearance joint, taken along the line of centres as in eqs. (1) to (3) and (34):
/// δ = e − [R_i(φ_i) − R_j(φ_j)], φ the direction of the line of centres in either body.
struct RevoluteGap : ContactGap, CentreLine {};

/// Writes all of the gap, its gradient and the local radii. With the centres on top of each other n is taken along x.
/// Each member is written once, where it stays: a copy of it all would wait for the single stores before it.
inline CentreLine update_revolute_gap(const RevoluteSurfaces& surfaces, const RelativeMotion& motion,
                                      ContactGap& gap) noexcept {
  const double eccentricity = norm(motion.offset);
  const double inverse_eccentricity = 1.0 / eccentricity;
  const Vec2 normal = eccentricity > 0.0 ? inverse_eccentricity * motion.offset : Vec2{1.0, 0.0};
  const double approach = dot(normal, motion.velocity);
  double direction = 0.0;
  double bearing_radius = surfaces.bearing_radius;
  double journal_radius = surfaces.journal_radius;
  double clearance = bearing_radius - journal_radius;
  double inverse_clearance = 1.0 / clearance;
  gap.normal = normal;
  if (surfaces.is_worn() && eccentricity > 0.0) {
    direction = std::atan2(normal.y, normal.x);
    const auto bearing = surfaces.bearing_wear.eval(direction - motion.bearing_angle);
    const auto journal = surfaces.journal_wear.eval(direction - motion.journal_angle);
    bearing_radius += bearing.depth;
    journal_radius -= journal.depth;
    clearance = bearing_radius - journal_radius;
    inverse_clearance = 1.0 / clearance;
    const double direction_rate = cross(normal, motion.velocity) * inverse_eccentricity;
    const double bearing_radius_rate = bearing.slope * (direction_rate - motion.bearing_rate);
    const double journal_radius_rate = -journal.slope * (direction_rate - motion.journal_rate);
    const double clearance_rate = (bearing_radius_rate - journal_radius_rate) * inverse_clearance;
    gap.bearing_depth = bearing.depth;
    gap.journal_depth = journal.depth;
    // ∂φ/∂r = perp(n)/e; R_i falls with δ, R_j adds to it.
    gap.gradient = normal - ((bearing.slope + journal.slope) * inverse_eccentricity) * perp(normal);
    gap.bearing_gradient = bearing.slope;
    gap.journal_gradient = journal.slope;
    gap.bearing_radius_rate = bearing_radius_rate;
    gap.journal_radius_rate = journal_radius_rate;
    gap.penetration_rate = approach + (journal_radius_rate - bearing_radius_rate);
    gap.clearance_rate = clearance_rate;
    gap.relative_radius_rate = (bearing_radius_rate * journal_radius + journal_radius_rate * bearing_radius) /
                                   (bearing_radius * journal_radius) -
                               clearance_rate;
  } else {
    gap.bearing_depth = gap.journal_depth = 0.0;
    gap.gradient = normal;
    gap.bearing_gradient = gap.journal_gradient = 0.0;
    gap.bearing_radius_rate = gap.journal_radius_rate = 0.0;
    gap.penetration_rate = approach;
    gap.clearance_rate = gap.relative_radius_rate = 0.0;
  }
  const double penetration = eccentricity - clearance;
  const double journal_lever = journal_radius - 0.5 * penetration;
  gap.penetration = penetration;
  gap.bearing_radius = bearing_radius;
  gap.journal_radius = journal_radius;
  gap.relative_radius = bearing_radius * journal_radius * inverse_clearance;
  gap.journal_lever = journal_lever;
  gap.bearing_lever = eccentricity + journal_lever;
  gap.bearing_position = 0.0;
  return {eccentricity, direction};
}

inline RevoluteGap find_revolute_gap(const RevoluteSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  RevoluteGap gap;
  static_cast<CentreLine&>(gap) = update_revolute_gap(surfaces, motion, gap);
  return gap;
}

}  // namespace gudgeon
