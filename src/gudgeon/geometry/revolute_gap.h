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

/// The gap of a revolute clearance joint, taken along the line of centres as in eqs. (1) to (3) and (34):
/// δ = e − [R_i(φ_i) − R_j(φ_j)], φ the direction of the line of centres in either body.
struct RevoluteGap : ContactGap {
  double eccentricity = 0.0;  ///< e [m], between the centres
  double direction = 0.0;     ///< angle of n in the frame [rad]; only set for worn surfaces
};

/// The gap, its gradient and the local radii. With the centres on top of each other n is taken along x.
inline RevoluteGap find_revolute_gap(const RevoluteSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  RevoluteGap gap;
  gap.eccentricity = norm(motion.offset);
  const double inverse_eccentricity = 1.0 / gap.eccentricity;
  gap.normal = gap.eccentricity > 0.0 ? inverse_eccentricity * motion.offset : Vec2{1.0, 0.0};
  gap.gradient = gap.normal;
  gap.bearing_radius = surfaces.bearing_radius;
  gap.journal_radius = surfaces.journal_radius;
  gap.penetration_rate = dot(gap.normal, motion.velocity);
  double clearance = gap.bearing_radius - gap.journal_radius;
  double inverse_clearance = 1.0 / clearance;
  if (surfaces.is_worn() && gap.eccentricity > 0.0) {
    gap.direction = std::atan2(gap.normal.y, gap.normal.x);
    const auto bearing = surfaces.bearing_wear.eval(gap.direction - motion.bearing_angle);
    const auto journal = surfaces.journal_wear.eval(gap.direction - motion.journal_angle);
    gap.bearing_depth = bearing.depth;
    gap.journal_depth = journal.depth;
    gap.bearing_radius += bearing.depth;
    gap.journal_radius -= journal.depth;
    clearance = gap.bearing_radius - gap.journal_radius;
    inverse_clearance = 1.0 / clearance;
    // ∂φ/∂r = perp(n)/e; R_i falls with δ, R_j adds to it.
    gap.gradient -= ((bearing.slope + journal.slope) * inverse_eccentricity) * perp(gap.normal);
    gap.bearing_gradient = bearing.slope;
    gap.journal_gradient = journal.slope;
    const double direction_rate = cross(gap.normal, motion.velocity) * inverse_eccentricity;
    gap.bearing_radius_rate = bearing.slope * (direction_rate - motion.bearing_rate);
    gap.journal_radius_rate = -journal.slope * (direction_rate - motion.journal_rate);
    gap.penetration_rate += gap.journal_radius_rate - gap.bearing_radius_rate;
    gap.clearance_rate = (gap.bearing_radius_rate - gap.journal_radius_rate) * inverse_clearance;
    gap.relative_radius_rate =
        (gap.bearing_radius_rate * gap.journal_radius + gap.journal_radius_rate * gap.bearing_radius) /
            (gap.bearing_radius * gap.journal_radius) -
        gap.clearance_rate;
  }
  gap.penetration = gap.eccentricity - clearance;
  gap.relative_radius = gap.bearing_radius * gap.journal_radius * inverse_clearance;
  gap.journal_lever = gap.journal_radius - 0.5 * gap.penetration;
  gap.bearing_lever = gap.eccentricity + gap.journal_lever;
  return gap;
}

}  // namespace gudgeon
