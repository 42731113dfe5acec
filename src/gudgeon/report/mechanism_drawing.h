// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A picture of a linkage in one position, in the manner of a textbook.
//
// The input is plain geometry in the frame's axes, so that the picture needs neither the model nor the engine.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

struct DrawnBody {
  std::string name;
  bool is_frame = false;
  std::vector<Vec2> points;  ///< [m] its named points in the frame
  Vec2 center_of_mass;       ///< [m] in the frame; drawn only when a body has a single point
};

enum class DrawnJointKind {
  revolute,
  clearance,  ///< a journal in a bearing
  prismatic,
  prismatic_clearance,
  pin_in_slot,
  pin_in_slot_clearance,
  rigid
};

inline bool is_slide(DrawnJointKind kind) {
  return kind == DrawnJointKind::prismatic || kind == DrawnJointKind::prismatic_clearance;
}
inline bool is_slotted(DrawnJointKind kind) {
  return kind == DrawnJointKind::pin_in_slot || kind == DrawnJointKind::pin_in_slot_clearance;
}
inline bool shows_clearance(DrawnJointKind kind) {
  return kind == DrawnJointKind::clearance || kind == DrawnJointKind::prismatic_clearance ||
         kind == DrawnJointKind::pin_in_slot_clearance;
}

struct DrawnJoint {
  std::string name;
  DrawnJointKind kind = DrawnJointKind::revolute;
  int first_body = 0;      ///< index into bodies; the guide or slot
  int second_body = 0;     ///< index into bodies; what slides
  Vec2 first;              ///< [m] the first body's point in the frame
  Vec2 second;             ///< [m] the second body's point in the frame
  double direction = 0.0;  ///< [rad] of the line of a guide or slot in the frame
  double length = 0.0;     ///< [m] of the slot; 0 when it has none given
};

struct DrawnDriver {
  int body = 0;            ///< index into bodies: what is driven
  bool is_slide = false;   ///< along a line, not about a pivot
  Vec2 pivot;              ///< [m] centre of the turn, or the sliding point, in the frame
  double direction = 0.0;  ///< [rad] of the line, for a slide
  double speed = 0.0;      ///< only its sign is shown
};

/// The path of a point.
struct DrawnTrace {
  std::string name;
  std::vector<Vec2> points;  ///< [m] in the frame
};

struct MechanismDrawing {
  std::string title;
  std::string subtitle;
  std::vector<DrawnBody> bodies;
  std::vector<DrawnJoint> joints;
  std::vector<DrawnDriver> drivers;
  std::vector<DrawnTrace> traces;
  Vec2 gravity;  ///< [m/s^2]; no arrow when zero
};

/// The picture as SVG, 800 px wide, on its own white ground.
std::string render_svg(const MechanismDrawing& drawing);

}  // namespace gudgeon
