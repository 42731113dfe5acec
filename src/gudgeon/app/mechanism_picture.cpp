// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The picture's geometry.
#include "gudgeon/app/mechanism_picture.h"

#include <fmt/format.h>

#include <optional>

namespace gudgeon {
namespace {

Vec2 find_anchor(const Mechanism& mechanism, const Assembly& assembly, const Anchor& anchor) {
  const int body = find_body(mechanism, anchor.body);
  return assembly.poses[body].find_point(find_point(mechanism.bodies[body], anchor.point)->position);
}

DrawnBody make_body(const Body& body, const BodyPose& pose) {
  DrawnBody drawn{body.name, body.name == kFrameName, {}, pose.find_point(body.center_of_mass)};
  for (const Point& point : body.points) drawn.points.push_back(pose.find_point(point.position));
  return drawn;
}

DrawnJointKind find_kind(const AnyJoint& joint) {
  if (std::holds_alternative<PrismaticClearance>(joint)) return DrawnJointKind::prismatic_clearance;
  if (std::holds_alternative<PinInSlotClearance>(joint)) return DrawnJointKind::pin_in_slot_clearance;
  if (std::holds_alternative<PinInSlot>(joint)) return DrawnJointKind::pin_in_slot;
  if (has_clearance(joint)) return DrawnJointKind::clearance;
  if (std::holds_alternative<Prismatic>(joint)) return DrawnJointKind::prismatic;
  if (std::holds_alternative<Rigid>(joint)) return DrawnJointKind::rigid;
  return DrawnJointKind::revolute;
}

DrawnJoint make_joint(const Mechanism& mechanism, const Assembly& assembly, const Joint& joint) {
  const auto [first, second] = anchors(joint.kind);
  DrawnJoint drawn{joint.name,
                   find_kind(joint.kind),
                   find_body(mechanism, first.body),
                   find_body(mechanism, second.body),
                   find_anchor(mechanism, assembly, first),
                   find_anchor(mechanism, assembly, second)};
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.direction; }) {
          drawn.direction = kind.direction + assembly.poses[drawn.first_body].angle;
        }
        if constexpr (requires { kind.bearing_length; }) drawn.length = kind.bearing_length;
      },
      joint.kind);
  return drawn;
}

/// Where the body turns: its joint with the frame, or else its origin.
Vec2 find_pivot(const MechanismDrawing& drawing, int body, const BodyPose& pose) {
  for (const DrawnJoint& joint : drawing.joints) {
    if (is_slide(joint.kind) || is_slotted(joint.kind)) continue;
    if (joint.first_body == body && drawing.bodies[joint.second_body].is_frame) return joint.first;
    if (joint.second_body == body && drawing.bodies[joint.first_body].is_frame) return joint.second;
  }
  return pose.position;
}

DrawnDriver make_driver(const Mechanism& mechanism, const Assembly& assembly, const MechanismDrawing& drawing,
                        const Driver& driver) {
  if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
    const int body = find_body(mechanism, angle->body);
    return {body, false, find_pivot(drawing, body, assembly.poses[body]), 0.0, driver.speed};
  }
  const int index = find_joint(mechanism, std::get<DrivenSlide>(driver.target).joint);
  const DrawnJoint& joint = drawing.joints[index];
  const bool block_is_frame = drawing.bodies[joint.second_body].is_frame;
  return {block_is_frame ? joint.first_body : joint.second_body, true, block_is_frame ? joint.first : joint.second,
          joint.direction, block_is_frame ? -driver.speed : driver.speed};
}

/// Takes an assembled position as the next guess.
void update_start(Mechanism& mechanism, const Assembly& assembly) {
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    mechanism.bodies[i].start.angle = assembly.poses[i].angle;
    mechanism.bodies[i].start.position = assembly.poses[i].position;
  }
  for (Joint& joint : mechanism.joints) {
    auto* slide = std::get_if<Prismatic>(&joint.kind);
    if (slide == nullptr) continue;
    const double direction = slide->direction + assembly.poses[find_body(mechanism, slide->first.body)].angle;
    slide->start.displacement =
        dot(make_rotation(direction) * Vec2{1.0, 0.0},
            find_anchor(mechanism, assembly, slide->second) - find_anchor(mechanism, assembly, slide->first));
  }
}

}  // namespace

MechanismDrawing make_drawing(const Mechanism& mechanism, const Assembly& assembly) {
  MechanismDrawing drawing;
  drawing.gravity = mechanism.gravity;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    drawing.bodies.push_back(make_body(mechanism.bodies[i], assembly.poses[i]));
  }
  for (const Joint& joint : mechanism.joints) drawing.joints.push_back(make_joint(mechanism, assembly, joint));
  for (const Driver& driver : mechanism.drivers) {
    drawing.drivers.push_back(make_driver(mechanism, assembly, drawing, driver));
  }
  return drawing;
}

DrawnTrace make_trace(const Mechanism& mechanism, const Anchor& anchor, double duration) {
  constexpr int kSamples = 240;  // 1.5 degrees of a turn: smooth on paper
  Mechanism moving = mechanism;
  DrawnTrace trace{fmt::format("{}.{}", anchor.body, anchor.point), {}};
  for (int i = 0; i <= kSamples; ++i) {
    const Assembly assembly = assemble(moving, duration * i / kSamples);
    trace.points.push_back(find_anchor(moving, assembly, anchor));
    update_start(moving, assembly);
  }
  return trace;
}

}  // namespace gudgeon
