// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From a mechanism's geometry to outlines and spots on the sheet.
#include "gudgeon/report/drawing_plan.h"

#include <algorithm>
#include <array>

namespace gudgeon {
namespace {

constexpr std::array<BodyColors, 8> kPalette = {{{"#d0ebff", "#1971c2"},
                                                 {"#d3f9d8", "#2b8a3e"},
                                                 {"#f3d9fa", "#9c36b5"},
                                                 {"#fff3bf", "#7f5f01"},
                                                 {"#c5f6fa", "#0b7285"},
                                                 {"#ffdeeb", "#c2255c"},
                                                 {"#dbe4ff", "#364fc7"},
                                                 {"#e9fac8", "#4a7a0c"}}};

std::vector<Vec2> find_shape(const DrawnBody& body, const DrawingView& view) {
  std::vector<Vec2> points;
  for (const Vec2 point : body.points) points.push_back(view.place(point));
  std::vector<Vec2> hull = find_convex_hull(points);
  if (hull.size() >= 2 || body.is_frame) return hull;
  // A pendulum's bar ends at its centre of mass.
  points.push_back(view.place(body.center_of_mass));
  return find_convex_hull(points);
}

bool find_is_block(const MechanismDrawing& drawing, int body) {
  const std::vector<Vec2>& points = drawing.bodies[body].points;
  const bool is_spot = std::ranges::all_of(points, [&](Vec2 point) { return point == points.front(); });
  return is_spot && std::ranges::any_of(drawing.joints, [&](const DrawnJoint& joint) {
           return is_slide(joint.kind) && (joint.first_body == body || joint.second_body == body);
         });
}

void add_spot(DrawingPlan& plan, const DrawnJoint& joint) {
  constexpr double kSameSpot = 2.0;  // [px]: circles nearer than this cannot be told apart
  // A pin stands where it is in its slot, on its own body: the slot's does not hold it there.
  const Vec2 center = plan.view.place(is_slotted(joint.kind) ? joint.second : joint.first);
  const bool on_frame =
      plan.is_frame(joint.second_body) || (!is_slotted(joint.kind) && plan.is_frame(joint.first_body));
  const auto same =
      std::ranges::find_if(plan.spots, [&](const JointSpot& spot) { return norm(spot.center - center) < kSameSpot; });
  if (same == plan.spots.end()) {
    plan.spots.push_back({center, joint.name, joint.kind, on_frame});
    return;
  }
  same->names += ", " + joint.name;
  same->on_frame = same->on_frame || on_frame;
  if (shows_clearance(joint.kind)) same->kind = joint.kind;
}

}  // namespace

DrawingPlan make_plan(const MechanismDrawing& drawing) {
  DrawingPlan plan{drawing, make_view(drawing), {}, {}, {}};
  for (int i = 0; i < std::ssize(drawing.bodies); ++i) {
    plan.shapes.push_back(find_shape(drawing.bodies[i], plan.view));
    plan.is_block.push_back(find_is_block(drawing, i));
  }
  for (const DrawnJoint& joint : drawing.joints) {
    if (!is_slide(joint.kind)) add_spot(plan, joint);
  }
  return plan;
}

Vec2 find_block_center(const DrawingPlan& plan, const DrawnJoint& joint) {
  return plan.view.place(plan.is_frame(joint.second_body) ? joint.first : joint.second);
}

int find_block_body(const DrawingPlan& plan, const DrawnJoint& joint) {
  return plan.is_frame(joint.second_body) ? joint.first_body : joint.second_body;
}

BodyColors find_colors(int body) {
  // Body 0 is the frame, which has no colour of its own.
  return kPalette[static_cast<std::size_t>(body + kPalette.size() - 1) % kPalette.size()];
}

}  // namespace gudgeon
