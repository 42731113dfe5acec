// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Balls that fly inside bearings of the frame: motions with closed forms until they touch.
#pragma once

#include <string>

#include "gudgeon/model/mechanism.h"

namespace gudgeon {

inline constexpr double kBallBearingRadius = 1.0;
inline constexpr double kBallClearance = 0.5;  ///< [m]: the ball's centre is free within this distance

/// Where a ball is at the start, relative to the centre of its bearing, and how it flies.
struct BallFlight {
  Vec2 position;
  Vec2 velocity;
  double angle_rate = 0.0;
};

/// Surfaces so soft that a touch is not felt in the short time a test looks at.
inline constexpr double kNoStiffness = 1e-20;

/// One ball of 2 kg a flight, "ball_0" …, in bearings "wall_0" … side by side; the Young's modulus in Pa.
inline Mechanism make_balls(const std::vector<BallFlight>& flights, Vec2 gravity, double young_modulus) {
  Mechanism mechanism;
  mechanism.name = "balls";
  mechanism.gravity = gravity;
  mechanism.bodies.push_back({kFrameName, 0.0, 0.0, {}, {}, {}});
  for (std::size_t k = 0; k < flights.size(); ++k) {
    const std::string index = std::to_string(k);
    const Vec2 middle{3.0 * static_cast<double>(k), 0.0};
    mechanism.bodies[0].points.push_back({"bearing_" + index, middle});
    const BodyStart start{0.0, flights[k].angle_rate, middle + flights[k].position, flights[k].velocity};
    mechanism.bodies.push_back({"ball_" + index, 2.0, 0.1, {}, {{"journal", {}}}, start});
    RevoluteClearance joint{
        {kFrameName, "bearing_" + index}, {"ball_" + index, "journal"}, kBallBearingRadius, kBallClearance, 1.0, {}};
    joint.contact.bearing_material = joint.contact.journal_material = {"test", young_modulus, 0.0};
    joint.contact.normal_force = Hertz{};
    joint.contact.friction = Frictionless{};
    mechanism.joints.push_back({"wall_" + index, joint});
  }
  return mechanism;
}

}  // namespace gudgeon
