// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The signs of kinematics, in pixels: ground, bars, joints, sliders, arrows.
#pragma once

#include <string_view>
#include <vector>

#include "gudgeon/base/vec2.h"
#include "gudgeon/report/svg_canvas.h"

namespace gudgeon {

namespace ink {
inline constexpr std::string_view kLine = "#1f2933";
inline constexpr std::string_view kGround = "#52606d";
inline constexpr std::string_view kPaper = "#ffffff";
inline constexpr std::string_view kClearance = "#d9480f";
inline constexpr std::string_view kDriver = "#1864ab";
inline constexpr std::string_view kTrace = "#7b8794";
}  // namespace ink

inline constexpr double kBarWidth = 15.0;          ///< [px]
inline constexpr double kJointRadius = 5.0;        ///< [px] of an ideal joint's circle
inline constexpr double kClearanceRadius = 10.5;   ///< [px] of a clearance joint's outer ring
inline constexpr double kSupportHeight = 25.0;     ///< [px] of a frame pivot's triangle
inline constexpr double kDriverRadius = 31.0;      ///< [px] of a driver's arc
inline constexpr Vec2 kBlockHalfSize{25.0, 15.0};  ///< [px] of a slider, along and across its line
inline constexpr double kGuideHalfLength = 64.0;   ///< [px]
inline constexpr double kShownClearance = 5.0;     ///< [px] between a block and each side of its slot

/// The fill and outline of one body.
struct BodyColors {
  std::string_view fill;
  std::string_view outline;
};

/// Corners of the convex hull, counter-clockwise in the axes given; two for points on a line, one for a single spot.
std::vector<Vec2> find_convex_hull(std::vector<Vec2> points);

/// The body as a rounded plate around its outline's corners (two: a bar).
void draw_plate(SvgCanvas& canvas, const std::vector<Vec2>& corners, const BodyColors& colors);
/// A frame pivot's support below it.
void draw_support(SvgCanvas& canvas, Vec2 pivot);
/// A fixed line along a unit direction, hatched on the side of the unit vector `below`.
void draw_ground_line(SvgCanvas& canvas, Vec2 center, Vec2 along, Vec2 below, double half_length);
/// A slider's block, its length along a unit direction.
void draw_block(SvgCanvas& canvas, Vec2 center, Vec2 along, const BodyColors& colors);
void draw_revolute(SvgCanvas& canvas, Vec2 center);
void draw_clearance(SvgCanvas& canvas, Vec2 center);
/// A straight slot with round ends about two points: its outline, and what lies within and hides outlines drawn before.
void draw_slot_outline(SvgCanvas& canvas, Vec2 from, Vec2 to, double half_width, std::string_view color);
void draw_slot_inside(SvgCanvas& canvas, Vec2 from, Vec2 to, double half_width);
/// The pin of a slot.
void draw_pin(SvgCanvas& canvas, Vec2 center, bool has_clearance);
void draw_rigid(SvgCanvas& canvas, Vec2 center);
/// A straight arrow with its head at `to`.
void draw_arrow(SvgCanvas& canvas, Vec2 from, Vec2 to, std::string_view color);
/// An arc with a head at its second end; angles [rad] counter-clockwise on the sheet.
void draw_turn_arrow(SvgCanvas& canvas, Vec2 center, double from, double to, std::string_view color);

}  // namespace gudgeon
