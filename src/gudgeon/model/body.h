// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A rigid body as the user describes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

/// The name of the fixed body that every mechanism has.
inline constexpr const char* kFrameName = "frame";

struct Point {
  std::string name;
  Vec2 position;  ///< [m] in the body's own axes, from its origin
};

/// Where a body is at the start; assembly takes it as a guess and finds the rest.
struct BodyStart {
  std::optional<double> angle;       ///< θ [rad] of the body's x axis against the frame's
  std::optional<double> angle_rate;  ///< θ̇ [rad/s]
  std::optional<Vec2> position;      ///< [m] of the body's origin in the frame
  std::optional<Vec2> velocity;      ///< [m/s] of the body's origin
};

struct Body {
  std::string name;
  double mass = 0.0;     ///< m [kg]
  double inertia = 0.0;  ///< I [kg m^2] about the centre of mass
  Vec2 center_of_mass;   ///< [m] in the body's own axes
  std::vector<Point> points;
  BodyStart start;
};

}  // namespace gudgeon
