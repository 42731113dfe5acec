// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a mechanism's picture is made of, in pixels: each body's outline and every joint's spot.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/report/drawing_view.h"
#include "gudgeon/report/mechanism_drawing.h"
#include "gudgeon/report/mechanism_symbols.h"

namespace gudgeon {

/// One circle on the sheet: all joints whose points coincide there.
struct JointSpot {
  Vec2 center;        ///< [px]
  std::string names;  ///< "D2, D3"
  DrawnJointKind kind = DrawnJointKind::revolute;
  bool on_frame = false;
};

struct DrawingPlan {
  const MechanismDrawing& drawing;
  DrawingView view;
  std::vector<std::vector<Vec2>> shapes;  ///< [px] hull corners of each body
  std::vector<bool> is_block;             ///< bodies shown only by their slider's block
  std::vector<JointSpot> spots;           ///< of all joints but guides

  [[nodiscard]] bool is_frame(int body) const { return drawing.bodies[body].is_frame; }
};

/// The plan refers to the drawing, which must outlive it.
DrawingPlan make_plan(const MechanismDrawing& drawing);

/// Where the block of a prismatic joint stands [px]: on what moves, when one side is the frame.
Vec2 find_block_center(const DrawingPlan& plan, const DrawnJoint& joint);
/// The body whose block it is.
int find_block_body(const DrawingPlan& plan, const DrawnJoint& joint);

BodyColors find_colors(int body);

}  // namespace gudgeon
