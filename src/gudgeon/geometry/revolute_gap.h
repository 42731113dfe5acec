// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where a journal stands in its bearing, and how deep the two surfaces would overlap.
#pragma once

#include "gudgeon/base/vec2.h"
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

/// Relative position and motion of the two centres, journal minus bearing, and the angles of the two bodies.
struct RevoluteMotion {
  Vec2 offset;                 ///< [m] in the frame's axes
  Vec2 velocity;               ///< [m/s]
  double bearing_angle = 0.0;  ///< [rad]
  double journal_angle = 0.0;
  double bearing_rate = 0.0;  ///< [rad/s]
  double journal_rate = 0.0;
};

/// The gap of a revolute clearance joint, taken along the line of centres as in eqs. (1) to (3) and (34):
/// δ = e − [R_i(φ_i) − R_j(φ_j)], φ the direction of the line of centres in either body.
struct RevoluteGap {
  double eccentricity = 0.0;         ///< e [m]
  Vec2 normal;                       ///< n [1], from the bearing's centre to the journal's
  double penetration = 0.0;          ///< δ [m], > 0 in contact
  double penetration_rate = 0.0;     ///< δ̇ [m/s], > 0 while approaching
  double bearing_radius = 0.0;       ///< R_i(φ_i) [m], worn
  double journal_radius = 0.0;       ///< R_j(φ_j) [m], worn
  double bearing_slope = 0.0;        ///< dR_i/dφ [m/rad]
  double journal_slope = 0.0;        ///< dR_j/dφ [m/rad]
  double bearing_radius_rate = 0.0;  ///< [m/s] of R_i(φ_i) as the contact moves along the surface
  double journal_radius_rate = 0.0;  ///< [m/s] of R_j(φ_j)
  double direction = 0.0;            ///< angle of n in the frame [rad]; only set for worn surfaces
};

/// The gap, its rate and the local radii. With the centres on top of each other n is taken along x.
inline RevoluteGap find_revolute_gap(const RevoluteSurfaces& surfaces, const RevoluteMotion& motion) noexcept {
  RevoluteGap gap;
  gap.eccentricity = norm(motion.offset);
  gap.normal = gap.eccentricity > 0.0 ? (1.0 / gap.eccentricity) * motion.offset : Vec2{1.0, 0.0};
  gap.bearing_radius = surfaces.bearing_radius;
  gap.journal_radius = surfaces.journal_radius;
  const double eccentricity_rate = dot(gap.normal, motion.velocity);
  if (surfaces.is_worn() && gap.eccentricity > 0.0) {
    gap.direction = std::atan2(gap.normal.y, gap.normal.x);
    const double direction_rate = cross(gap.normal, motion.velocity) / gap.eccentricity;
    const auto bearing = surfaces.bearing_wear.eval(gap.direction - motion.bearing_angle);
    const auto journal = surfaces.journal_wear.eval(gap.direction - motion.journal_angle);
    gap.bearing_radius += bearing.depth;
    gap.journal_radius -= journal.depth;
    gap.bearing_slope = bearing.slope;
    gap.journal_slope = -journal.slope;
    gap.bearing_radius_rate = gap.bearing_slope * (direction_rate - motion.bearing_rate);
    gap.journal_radius_rate = gap.journal_slope * (direction_rate - motion.journal_rate);
  }
  gap.penetration = gap.eccentricity - (gap.bearing_radius - gap.journal_radius);
  gap.penetration_rate = eccentricity_rate - (gap.bearing_radius_rate - gap.journal_radius_rate);
  return gap;
}

}  // namespace gudgeon
