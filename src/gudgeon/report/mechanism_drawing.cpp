// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Puts a mechanism's signs on the sheet, lowest layer first, then the names.
#include "gudgeon/report/mechanism_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/report/drawing_names.h"
#include "gudgeon/report/drawing_plan.h"
#include "gudgeon/report/label_placement.h"
#include "gudgeon/report/mechanism_symbols.h"
#include "gudgeon/report/svg_canvas.h"

namespace gudgeon {
namespace {

/// The sheet, what is to be drawn, and what is taken.
struct Sketch {
  const DrawingPlan& plan;
  SvgCanvas& canvas;
  LabelPlacer& placer;
};

void draw_traces(Sketch sketch) {
  sketch.canvas.begin_group("traces");
  for (const DrawnTrace& trace : sketch.plan.drawing.traces) {
    std::vector<Vec2> points;
    for (const Vec2 point : trace.points) points.push_back(sketch.plan.view.place(point));
    sketch.canvas.add_polyline(points, {.stroke = ink::kTrace, .width = 1.4, .dashes = "5 4"});
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      sketch.placer.add_obstacle(Box{0.5 * (points[i] + points[i + 1]), {1.0, 1.0}});
    }
  }
  sketch.canvas.end_group();
}

void draw_supports(Sketch sketch) {
  sketch.canvas.begin_group("frame");
  for (const JointSpot& spot : sketch.plan.spots) {
    if (!spot.on_frame) continue;
    draw_support(sketch.canvas, spot.center);
    // The tip of the triangle leaves room beside it, its foot and hatching do not.
    const double half_height = 0.25 * (kSupportHeight + 10.0);
    sketch.placer.add_obstacle({spot.center + Vec2{0.0, half_height}, {10.0, half_height}});
    sketch.placer.add_obstacle({spot.center + Vec2{0.0, 3.0 * half_height}, {28.0, half_height}});
  }
  sketch.canvas.end_group();
}

void draw_bodies(Sketch sketch) {
  sketch.canvas.begin_group("bodies");
  const DrawingPlan& plan = sketch.plan;
  for (const bool plates : {true, false}) {  // plates lie below bars
    for (int i = 0; i < std::ssize(plan.shapes); ++i) {
      const std::vector<Vec2>& shape = plan.shapes[i];
      if (plan.is_frame(i) || plan.is_block[i] || shape.empty() || (shape.size() > 2) != plates) continue;
      draw_plate(sketch.canvas, shape, find_colors(i));
      for (std::size_t k = 0; k < shape.size(); ++k) {
        sketch.placer.add_obstacle_line(shape[k], shape[(k + 1) % shape.size()], kBarWidth + 3.0);
      }
    }
  }
  sketch.canvas.end_group();
}

/// The normal of a line that points down the sheet; of a vertical line, to the right.
Vec2 find_lower_side(Vec2 along) {
  const Vec2 normal = perp(along);
  const bool points_down = std::abs(normal.y) > 1e-9 ? normal.y > 0.0 : normal.x > 0.0;
  return points_down ? normal : -normal;
}

/// The fixed line that a block slides on, on its lower side.
void draw_fixed_guide(Sketch sketch, Vec2 block, Vec2 along) {
  const Vec2 below = find_lower_side(along);
  const Vec2 line = block + (kBlockHalfSize.y + 1.5) * below;
  draw_ground_line(sketch.canvas, line, along, below, kGuideHalfLength);
  const Vec2 reach = kGuideHalfLength * along;
  sketch.placer.add_obstacle_line(line + 4.0 * below - reach, line + 4.0 * below + reach, 12.0);
}

/// A rail from the guide body's point through the block, long enough to be seen on both sides.
void draw_moving_guide(Sketch sketch, const DrawnJoint& joint, Vec2 block, Vec2 along) {
  // A bar or plate that the block stands on needs no rail but a slot around the block.
  const std::vector<Vec2>& shape = sketch.plan.shapes[joint.first_body];
  const auto is_before = [&](Vec2 corner) { return dot(corner - block, along) < 0.0; };
  const bool stands_on_it = std::ranges::any_of(shape, is_before) && !std::ranges::all_of(shape, is_before);
  const double reach = stands_on_it ? 0.0 : dot(sketch.plan.view.place(joint.first) - block, along);
  const double overhang = kBlockHalfSize.x + 16.0;
  const Vec2 low = block + std::min(reach, -overhang) * along;
  const Vec2 high = block + std::max(reach, overhang) * along;
  sketch.canvas.add_line(low, high, {.stroke = find_colors(joint.first_body).outline, .width = 5.0});
  sketch.placer.add_obstacle_line(low, high, 6.0);
}

/// The two sides of a slot with clearance, as long as it is unless its block would hide it; the block stands between
/// them with a gap that can be seen.
void draw_clearance_guide(Sketch sketch, const DrawnJoint& joint, Vec2 block, Vec2 along) {
  const DrawingPlan& plan = sketch.plan;
  const bool slot_moves = !plan.is_frame(joint.first_body);
  const double half_length = 0.5 * joint.length * plan.view.scale;
  const bool is_seen = half_length > kBlockHalfSize.x;
  const Vec2 middle = is_seen ? plan.view.place(joint.first) : block;
  const Vec2 reach = (is_seen ? half_length : kGuideHalfLength) * along;
  for (const double side : {1.0, -1.0}) {
    const Vec2 outward = side * perp(along);
    const Vec2 line = middle + (kBlockHalfSize.y + kShownClearance) * outward;
    if (slot_moves) {
      sketch.canvas.add_line(line - reach, line + reach,
                             {.stroke = find_colors(joint.first_body).outline, .width = 4.0});
    } else {
      draw_ground_line(sketch.canvas, line, along, outward, norm(reach));
    }
    sketch.placer.add_obstacle_line(line + 4.0 * outward - reach, line + 4.0 * outward + reach, 12.0);
  }
}

/// A slot on the sheet, round at its ends.
struct SlotShape {
  Vec2 from;  ///< [px] centre of the round end
  Vec2 to;    ///< [px]
  double half_width = 0.0;
  bool is_fixed = false;
  std::string_view color;
};

/// A slot around its pin; without a length given, as long as a guide is drawn.
SlotShape make_slot(const DrawingPlan& plan, const DrawnJoint& joint) {
  const double half_width = kJointRadius + (shows_clearance(joint.kind) ? kShownClearance : 1.5);
  const Vec2 along = make_sheet_direction(joint.direction);
  const Vec2 middle = plan.view.place(joint.first);
  const double to_pin = dot(plan.view.place(joint.second) - middle, along);
  const double given = std::max(0.5 * joint.length * plan.view.scale - half_width, 0.0);
  const double half = joint.length > 0.0 ? given : std::max(std::abs(to_pin) + 2.0 * kJointRadius, kBlockHalfSize.x);
  const bool is_fixed = plan.is_frame(joint.first_body);
  return {middle - half * along, middle + half * along, half_width, is_fixed,
          is_fixed ? ink::kGround : find_colors(joint.first_body).outline};
}

/// Hatching along the lower side of a slot of the frame; of a vertical one, on the right.
void draw_slot_ground(Sketch sketch, const SlotShape& slot) {
  const Vec2 along = (1.0 / norm(slot.to - slot.from)) * (slot.to - slot.from);
  const Vec2 below = find_lower_side(along);
  const Vec2 line = 0.5 * (slot.from + slot.to) + (slot.half_width + 2.2) * below;
  draw_ground_line(sketch.canvas, line, along, below, 0.5 * norm(slot.to - slot.from));
  sketch.placer.add_obstacle_line(slot.from + (slot.half_width + 6.0) * below,
                                  slot.to + (slot.half_width + 6.0) * below, 10.0);
}

void draw_slots(Sketch sketch) {
  sketch.canvas.begin_group("slots");
  std::vector<SlotShape> slots;
  for (const DrawnJoint& joint : sketch.plan.drawing.joints) {
    if (is_slotted(joint.kind)) slots.push_back(make_slot(sketch.plan, joint));
  }
  for (const SlotShape& slot : slots) {
    if (slot.is_fixed && slot.from != slot.to) draw_slot_ground(sketch, slot);
  }
  // All outlines, then all insides: slots of one line make one slot.
  for (const SlotShape& slot : slots) draw_slot_outline(sketch.canvas, slot.from, slot.to, slot.half_width, slot.color);
  for (const SlotShape& slot : slots) draw_slot_inside(sketch.canvas, slot.from, slot.to, slot.half_width);
  for (const SlotShape& slot : slots) {
    sketch.placer.add_obstacle_line(slot.from, slot.to, 2.0 * slot.half_width + 4.0);
  }
  sketch.canvas.end_group();
}

void draw_slides(Sketch sketch) {
  sketch.canvas.begin_group("slides");
  for (const DrawnJoint& joint : sketch.plan.drawing.joints) {
    if (!is_slide(joint.kind)) continue;
    const Vec2 along = make_sheet_direction(joint.direction);
    const Vec2 block = find_block_center(sketch.plan, joint);
    if (shows_clearance(joint.kind)) {
      draw_clearance_guide(sketch, joint, block, along);
    } else if (sketch.plan.is_frame(joint.first_body) || sketch.plan.is_frame(joint.second_body)) {
      draw_fixed_guide(sketch, block, along);
    } else {
      draw_moving_guide(sketch, joint, block, along);
    }
    draw_block(sketch.canvas, block, along, find_colors(find_block_body(sketch.plan, joint)));
    const Vec2 reach = (kBlockHalfSize.x - kBlockHalfSize.y) * along;
    sketch.placer.add_obstacle_line(block - reach, block + reach, 2.4 * kBlockHalfSize.y);
  }
  sketch.canvas.end_group();
}

void draw_joints(Sketch sketch) {
  sketch.canvas.begin_group("joints");
  for (const JointSpot& spot : sketch.plan.spots) {
    if (spot.kind == DrawnJointKind::clearance) draw_clearance(sketch.canvas, spot.center);
    if (spot.kind == DrawnJointKind::revolute) draw_revolute(sketch.canvas, spot.center);
    if (is_slotted(spot.kind)) draw_pin(sketch.canvas, spot.center, shows_clearance(spot.kind));
    if (spot.kind == DrawnJointKind::rigid) draw_rigid(sketch.canvas, spot.center);
    const double radius = 1.0 + (spot.kind == DrawnJointKind::clearance ? kClearanceRadius : kJointRadius);
    sketch.placer.add_obstacle({spot.center, {radius, radius}});
  }
  sketch.canvas.end_group();
}

/// An angle to draw in: its middle and half its width, both [rad].
struct FreeAngle {
  double middle = 0.0;
  double half_width = 0.0;
};

/// The widest angle at a pivot that neither the driven body nor the support takes.
FreeAngle find_free_angle(const DrawingPlan& plan, const DrawnDriver& driver) {
  constexpr double kSupportHalfAngle = 0.7;  // [rad] that the support takes of a driver's circle
  const Vec2 pivot = plan.view.place(driver.pivot);
  std::vector<double> taken = {-0.5 * std::numbers::pi - kSupportHalfAngle,
                               -0.5 * std::numbers::pi + kSupportHalfAngle};
  for (const Vec2 corner : plan.shapes[driver.body]) {
    if (norm(corner - pivot) > 1.0) taken.push_back(std::atan2(pivot.y - corner.y, corner.x - pivot.x));
  }
  std::ranges::sort(taken);
  taken.push_back(taken.front() + 2.0 * std::numbers::pi);
  FreeAngle widest;
  for (std::size_t i = 0; i + 1 < taken.size(); ++i) {
    const double half_width = 0.5 * (taken[i + 1] - taken[i]);
    if (half_width > widest.half_width) widest = {0.5 * (taken[i + 1] + taken[i]), half_width};
  }
  return widest;
}

void draw_slide_driver(Sketch sketch, const DrawnDriver& driver, Vec2 pivot, double sense) {
  const Vec2 along = sense * make_sheet_direction(driver.direction);
  const Vec2 above = perp(along).y < 0.0 ? perp(along) : -perp(along);
  const Vec2 middle = pivot + (kBlockHalfSize.y + 11.0) * above;
  draw_arrow(sketch.canvas, middle - 24.0 * along, middle + 24.0 * along, ink::kDriver);
  sketch.placer.add_obstacle_line(middle - 24.0 * along, middle + 24.0 * along, 10.0);
}

void draw_turn_driver(Sketch sketch, const DrawnDriver& driver, Vec2 pivot, double sense) {
  constexpr double kLargestHalfSpan = 1.1;  // [rad]: longer arcs close up around the pivot
  constexpr double kGap = 0.3;              // [rad] kept from what the angle lies between
  const auto [middle, half_width] = find_free_angle(sketch.plan, driver);
  const double half_span = sense * std::min(kLargestHalfSpan, half_width - kGap);
  draw_turn_arrow(sketch.canvas, pivot, middle - half_span, middle + half_span, ink::kDriver);
  constexpr int kBoxes = 16;
  for (int i = 0; i <= kBoxes; ++i) {
    const double angle = middle + (2.0 * i / kBoxes - 1.0) * half_span;
    sketch.placer.add_obstacle({pivot + kDriverRadius * make_sheet_direction(angle), {6.0, 6.0}});
  }
}

void draw_drivers(Sketch sketch) {
  sketch.canvas.begin_group("drivers");
  for (const DrawnDriver& driver : sketch.plan.drawing.drivers) {
    const Vec2 pivot = sketch.plan.view.place(driver.pivot);
    const double sense = driver.speed < 0.0 ? -1.0 : 1.0;
    driver.is_slide ? draw_slide_driver(sketch, driver, pivot, sense) : draw_turn_driver(sketch, driver, pivot, sense);
  }
  sketch.canvas.end_group();
}

}  // namespace

std::string render_svg(const MechanismDrawing& drawing) {
  const DrawingPlan plan = make_plan(drawing);
  SvgCanvas canvas(plan.view.width, plan.view.height, drawing.title);
  const Vec2 sheet{plan.view.width, plan.view.height};
  constexpr double kEdge = 8.0;  // [px] that names keep from the sheet's edge
  LabelPlacer placer(Box{0.5 * sheet, 0.5 * sheet}.grown(-kEdge));
  const Sketch sketch{plan, canvas, placer};
  draw_supports(sketch);
  draw_bodies(sketch);
  draw_traces(sketch);
  draw_slides(sketch);
  draw_slots(sketch);
  draw_joints(sketch);
  draw_drivers(sketch);
  draw_margins(canvas, placer, plan);
  draw_names(canvas, placer, plan);
  return canvas.render();
}

}  // namespace gudgeon
