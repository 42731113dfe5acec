// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bars, guides and start guesses that the test mechanisms are put together from.
#pragma once

#include <numbers>
#include <string>
#include <utility>

#include "gudgeon/model/mechanism.h"

namespace gudgeon::oracle {

inline constexpr double kDegree = std::numbers::pi / 180.0;
inline constexpr Vec2 kObliqueGravity{2.3, -9.1};

inline Mechanism make_empty(std::string name, Vec2 gravity, std::vector<Point> frame_points) {
  Mechanism mechanism;
  mechanism.name = std::move(name);
  mechanism.gravity = gravity;
  mechanism.bodies.push_back({kFrameName, 0.0, 0.0, {}, std::move(frame_points), {}});
  return mechanism;
}

inline BodyStart start_at(double angle) {
  BodyStart start;
  start.angle = angle;
  return start;
}

inline BodyStart start_turning(double angle, double angle_rate) {
  BodyStart start = start_at(angle);
  start.angle_rate = angle_rate;
  return start;
}

/// A bar from its origin, point "a", to (length, 0), point "b".
inline Body make_bar(std::string name, double length, double mass, double inertia, Vec2 center, BodyStart start) {
  return {std::move(name), mass, inertia, center, {{"a", {0.0, 0.0}}, {"b", {length, 0.0}}}, start};
}

inline Body make_slender(std::string name, double length, double mass, BodyStart start) {
  return make_bar(std::move(name), length, mass, mass * length * length / 12.0, {0.5 * length, 0.0}, start);
}

inline void add_revolute(Mechanism& mechanism, std::string name, Anchor first, Anchor second) {
  mechanism.joints.push_back({std::move(name), Revolute{std::move(first), std::move(second)}});
}

inline Prismatic make_slide(Anchor first, Anchor second, double direction, double relative_angle, double displacement) {
  return {std::move(first), std::move(second), direction, relative_angle, {displacement, std::nullopt}};
}

}  // namespace gudgeon::oracle
