// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where a rounded corner or a pin stands against one straight side of its slot.
#pragma once

#include <limits>
#include <numbers>

#include "gudgeon/geometry/contact_gap.h"
#include "gudgeon/geometry/line_profile.h"
#include "gudgeon/geometry/radial_profile.h"

namespace gudgeon {

/// A circle of the journal's body that faces one straight side of a slot, each worn in its own body.
struct GuideSurfaces {
  double direction = 0.0;       ///< [rad] of the slot, in the bearing's body
  double side = 1.0;            ///< 1: the side to the left of the direction; -1: the one to the right
  double half_height = 0.0;     ///< H [m] of the unworn side from the middle of the slot
  double half_length = 0.0;     ///< [m] of the side, from the middle of the slot to either end
  double journal_radius = 0.0;  ///< R_j [m] of the corner or pin, unworn
  LineProfile bearing_wear;     ///< a side recedes by its depth
  RadialProfile journal_wear;   ///< a corner or pin shrinks by its depth

  [[nodiscard]] bool is_worn() const { return bearing_wear.is_worn() || journal_wear.is_worn(); }
};

/// The gap of a circle at offset r from the middle of the slot, n across the slot and t along it:
/// δ = n·r + R_j(φ_j) − [H + h_i(s)], s = t·r, φ_j the direction of n in the journal's body.
struct GuideGap : ContactGap {
  double reach = 0.0;          ///< [m] penetration if both surfaces were worn by their least depths everywhere; >= δ
  double reach_rate = 0.0;     ///< [m/s]
  double position_rate = 0.0;  ///< ṡ [m/s]
};

/// The gap, its gradient and the local radii.
inline GuideGap find_guide_gap(const GuideSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  GuideGap gap;
  const Rotation turned = make_rotation(motion.bearing_angle + surfaces.direction);
  const Vec2 along{turned.c, turned.s};
  gap.normal = surfaces.side * perp(along);
  const double height = dot(gap.normal, motion.offset);
  gap.gradient = gap.normal;
  gap.bearing_gradient = cross(gap.normal, motion.offset);
  gap.bearing_radius = std::numeric_limits<double>::infinity();
  gap.journal_radius = surfaces.journal_radius;
  gap.bearing_position = dot(along, motion.offset);
  gap.position_rate = dot(along, motion.velocity) + motion.bearing_rate * cross(along, motion.offset);
  gap.penetration_rate = dot(gap.normal, motion.velocity) + motion.bearing_rate * gap.bearing_gradient;
  gap.penetration = height + surfaces.journal_radius - surfaces.half_height;
  gap.reach = gap.penetration - surfaces.bearing_wear.least_depth() - surfaces.journal_wear.least_depth();
  gap.reach_rate = gap.penetration_rate;
  if (surfaces.is_worn()) {
    const double direction = motion.bearing_angle + surfaces.direction + surfaces.side * 0.5 * std::numbers::pi;
    const auto bearing = surfaces.bearing_wear.eval(gap.bearing_position);
    const auto journal = surfaces.journal_wear.eval(direction - motion.journal_angle);
    gap.bearing_depth = bearing.depth;
    gap.journal_depth = journal.depth;
    gap.journal_radius -= journal.depth;
    gap.penetration -= bearing.depth + journal.depth;
    // ∂s/∂r = t, ∂s/∂θ_i = t×r, ∂φ_j/∂θ_i = 1 = −∂φ_j/∂θ_j.
    gap.gradient -= bearing.slope * along;
    gap.bearing_gradient -= bearing.slope * cross(along, motion.offset) + journal.slope;
    gap.journal_gradient = journal.slope;
    gap.journal_radius_rate = -journal.slope * (motion.bearing_rate - motion.journal_rate);
    gap.relative_radius_rate = gap.journal_radius_rate / gap.journal_radius;
    gap.penetration_rate += gap.journal_radius_rate - bearing.slope * gap.position_rate;
  }
  gap.relative_radius = gap.journal_radius;
  gap.journal_lever = gap.journal_radius - 0.5 * gap.penetration;
  gap.bearing_lever = height + gap.journal_lever;
  return gap;
}

}  // namespace gudgeon
