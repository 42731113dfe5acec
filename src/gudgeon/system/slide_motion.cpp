// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Relative motion of two points in axes that turn with the first body.
#include "gudgeon/system/slide_motion.h"

namespace gudgeon {

namespace {

struct PointMotion {
  Vec2 position;
  Vec2 velocity;
  Vec2 acceleration;
};

PointMotion find_point_motion(const Mechanism& mechanism, const Anchor& anchor,
                              const std::vector<BodyMotion>& motions) {
  const int index = find_body(mechanism, anchor.body);
  const Body& body = mechanism.bodies[index];
  const BodyMotion& motion = motions[index];
  const Vec2 arm = make_rotation(motion.angle) * (find_point(body, anchor.point)->position - body.center_of_mass);
  return {motion.position + arm, motion.velocity + motion.angle_rate * perp(arm),
          motion.acceleration + motion.angle_acceleration * perp(arm) - motion.angle_rate * motion.angle_rate * arm};
}

}  // namespace

bool has_line(const AnyJoint& joint) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        return requires { kind.direction; };
      },
      joint);
}

SlideMotion find_slide_motion(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& motions) {
  const auto [first, second] = anchors(joint.kind);
  const PointMotion from = find_point_motion(mechanism, first, motions);
  const PointMotion to = find_point_motion(mechanism, second, motions);
  const BodyMotion& carrier = motions[find_body(mechanism, first.body)];
  const Rotation along = make_rotation(carrier.angle + find_line_direction(joint.kind));
  const Vec2 axis{along.c, along.s};
  const Vec2 across = perp(axis);
  const Vec2 apart = to.position - from.position;
  const Vec2 velocity = to.velocity - from.velocity;
  const Vec2 acceleration = to.acceleration - from.acceleration;
  const double rate = carrier.angle_rate;
  return {dot(axis, apart), dot(axis, velocity) + rate * dot(across, apart),
          dot(axis, acceleration) + 2.0 * rate * dot(across, velocity) +
              carrier.angle_acceleration * dot(across, apart) - rate * rate * dot(axis, apart)};
}

}  // namespace gudgeon
