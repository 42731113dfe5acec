// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How far a joint's second point is along its line, and how fast it moves there.
#pragma once

#include "gudgeon/system/body_motion.h"

namespace gudgeon {

struct SlideMotion {
  double displacement = 0.0;  ///< [m]
  double speed = 0.0;         ///< [m/s]
  double acceleration = 0.0;  ///< [m/s^2]
};

/// Whether a joint has a line.
bool has_line(const AnyJoint& joint);

/// Seen from the joint's first body; needs the motions of all bodies. The joint must have a line.
SlideMotion find_slide_motion(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& motions);

}  // namespace gudgeon
