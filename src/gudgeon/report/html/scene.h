// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A mechanism as the page animates it: places on bodies, and what joins them.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

struct ScenePoint {
  std::string name;
  Vec2 place;  ///< [m] from the body's centre of mass, in the body's axes; from the origin for the frame
};

struct SceneBody {
  std::string name;
  bool is_frame = false;
  std::vector<ScenePoint> points;
};

struct SceneJoint {
  std::string name;
  std::string kind;           ///< as the model file has it, "revolute_clearance"
  int first = 0;              ///< index into bodies; the bearing's
  int second = 0;             ///< index into bodies; the journal's
  Vec2 first_place;           ///< [m] as ScenePoint::place
  Vec2 second_place;          ///< [m]
  double direction = 0.0;     ///< [rad] of a slide or slot, in the first body's axes
  double clearance = 0.0;     ///< [m] on either side; 0 for an ideal joint
  double slot_length = 0.0;   ///< [m] of a slot with clearance
  double block_length = 0.0;  ///< [m] of a block with clearance, along the slot
  double block_height = 0.0;  ///< [m] across
};

struct Scene {
  std::vector<SceneBody> bodies;
  std::vector<SceneJoint> joints;
  Vec2 gravity;  ///< [m/s^2]
};

}  // namespace gudgeon
