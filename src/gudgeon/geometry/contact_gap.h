// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What every pair of touching surfaces tells of itself, whatever its shape.
#pragma once

#include "gudgeon/base/vec2.h"

namespace gudgeon {

/// Position and motion of a journal's point relative to its bearing's, and the angles of the two bodies.
struct RelativeMotion {
  Vec2 offset;                 ///< [m] journal's point minus bearing's, in the frame's axes
  Vec2 velocity;               ///< [m/s]
  double bearing_angle = 0.0;  ///< [rad]
  double journal_angle = 0.0;
  double bearing_rate = 0.0;  ///< [rad/s]
  double journal_rate = 0.0;
};

/// The gap between two surfaces at one instant. The penetration δ depends on offset r and the two angles; its partial
/// derivatives give its rate, δ̇ = g·ṙ + g_i θ̇_i + g_j θ̇_j, and, by virtual work, the force and torques of a pressure F
/// along it: −F g on the journal, −F g_i on the bearing's body, −F g_j on the journal's.
struct ContactGap {
  Vec2 normal;                    ///< n [1], from the bearing's inside through the contact; a journal presses along it
  double penetration = 0.0;       ///< δ [m], > 0 in contact
  double penetration_rate = 0.0;  ///< δ̇ [m/s], > 0 while approaching
  Vec2 gradient;                  ///< g = ∂δ/∂r [1]; n on unworn surfaces
  double bearing_gradient = 0.0;  ///< g_i = ∂δ/∂θ_i [m/rad]
  double journal_gradient = 0.0;  ///< g_j = ∂δ/∂θ_j [m/rad]
  double bearing_radius = 0.0;    ///< R_i [m], local and worn; infinite where the bearing is flat
  double journal_radius = 0.0;    ///< R_j [m], local and worn
  double relative_radius = 0.0;   ///< R_r [m], 1/R_r = 1/R_j − 1/R_i
  double bearing_radius_rate = 0.0;   ///< [m/s] of R_i as the contact moves along the worn surface
  double journal_radius_rate = 0.0;   ///< [m/s] of R_j
  double relative_radius_rate = 0.0;  ///< d ln R_r/dt [1/s]
  double clearance_rate = 0.0;        ///< d ln ΔR/dt [1/s], ΔR = R_i − R_j; 0 where the bearing is flat
  double bearing_lever = 0.0;         ///< n·(middle of the overlap − bearing's point) [m]
  double journal_lever = 0.0;         ///< n·(middle of the overlap − journal's point) [m]
  double bearing_depth = 0.0;         ///< h_i [m] worn off the bearing here
  double journal_depth = 0.0;         ///< h_j [m] worn off the journal here
  double bearing_position = 0.0;      ///< s [m] along a flat bearing, from its middle; 0 on a round one
};

}  // namespace gudgeon
