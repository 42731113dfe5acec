// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A rigid body as the user describes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gudgeon/base/vec2.h"
#include "gudgeon/model/field.h"

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

  static constexpr auto kFields = std::tuple{
      field("angle", &BodyStart::angle,
            {.dimension = dimension::kAngle, .absent = "free", .meaning = "of the body's x axis against the frame's"}),
      field("angle_rate", &BodyStart::angle_rate,
            {.dimension = dimension::kAngularSpeed, .absent = "free", .meaning = "how fast the body turns"}),
      field("position", &BodyStart::position,
            {.dimension = dimension::kLength, .absent = "free", .meaning = "of the body's origin in the frame"}),
      field("velocity", &BodyStart::velocity,
            {.dimension = dimension::kSpeed, .absent = "free", .meaning = "of the body's origin in the frame"}),
  };
};

struct Body {
  std::string name;
  double mass = 0.0;     ///< m [kg]
  double inertia = 0.0;  ///< I [kg m^2] about the centre of mass
  Vec2 center_of_mass;   ///< [m] in the body's own axes
  std::vector<Point> points;
  BodyStart start;

  static constexpr std::string_view kMeaning = "a rigid body; the one called frame stands still and has points only";
  static constexpr auto kMassFields = std::tuple{
      field("mass", &Body::mass,
            {.required = true,
             .dimension = dimension::kMass,
             .symbol = "m",
             .range = kPositive,
             .code = "E-MODEL-003",
             .meaning = "of the body"}),
      field("inertia", &Body::inertia,
            {.required = true,
             .dimension = dimension::kInertia,
             .symbol = "I",
             .range = kNotNegative,
             .code = "E-MODEL-004",
             .meaning = "about the centre of mass; 0 for a point mass"}),
  };
  static constexpr auto kPlaceFields = std::tuple{
      field("center_of_mass", &Body::center_of_mass,
            {.dimension = dimension::kLength, .meaning = "in the body's own axes"}),
      field("start", &Body::start, {.meaning = "where the body is at the start, see Start values"}),
  };
  static constexpr auto kPointFields = std::tuple{
      field("points", &Body::points,
            {.dimension = dimension::kLength, .meaning = "by name, each in the body's own axes, from its origin"}),
  };
  static constexpr auto kFields = std::tuple_cat(kMassFields, kPlaceFields, kPointFields);
};

}  // namespace gudgeon
