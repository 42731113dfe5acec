// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The values of all turns and slides at one instant.
#pragma once

#include <vector>

#include "gudgeon/base/rotations.h"
#include "gudgeon/base/state_archive.h"
#include "gudgeon/base/vec2.h"
#include "gudgeon/system/motion_function.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

/// Angles, their cosines and sines, displacements, and the rates of all: free, driven, and the constant last one.
/// Behind the angles of the turns stand zeros that fill lanes. Owns the functions that its drivers' motions are
/// evaluated with.
struct Coordinates {
  explicit Coordinates(const CoordinateCounts& counts, const std::vector<DrivenMotion>& motions = {})
      : angle((static_cast<std::size_t>(counts.n_turns()) + kRotationLanes - 1) / kRotationLanes * kRotationLanes, 0.0),
        rotation(angle.size()),
        angle_rate(counts.n_turns(), 0.0),
        slide(counts.n_slides(), 1.0),
        slide_rate(counts.n_slides(), 0.0),
        driven(motions.size()),
        functions(motions.begin(), motions.end()) {}

  void transfer(StateArchive& archive) { archive(angle, rotation, angle_rate, slide, slide_rate, driven); }

  std::vector<double> angle;              ///< θ [rad], one a turn
  std::vector<Rotation> rotation;         ///< of θ
  std::vector<double> angle_rate;         ///< θ̇ [rad/s]
  std::vector<double> slide;              ///< c [m], one a slide; the unit slide is 1
  std::vector<double> slide_rate;         ///< ċ [m/s]
  std::vector<DrivenValue> driven;        ///< what the drivers ask for, one a motion of the tables
  std::vector<MotionFunction> functions;  ///< one a motion
};

}  // namespace gudgeon
