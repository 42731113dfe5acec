// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A guide without clearance.
#pragma once

#include <optional>

#include "gudgeon/model/field.h"
#include "gudgeon/model/joint/anchor.h"
#include "gudgeon/model/joint/friction.h"

namespace gudgeon {

/// Where a slide is at the start.
struct SlideStart {
  std::optional<double> displacement;  ///< [m] along the line, a guess where a loop determines it
  std::optional<double> speed;         ///< [m/s]

  static constexpr auto kFields = std::tuple{
      field("displacement", &SlideStart::displacement,
            {.dimension = dimension::kLength,
             .absent = "free",
             .meaning = "along the line; a guess where a loop determines it"}),
      field("speed", &SlideStart::speed,
            {.dimension = dimension::kSpeed, .absent = "free", .meaning = "along the line"}),
  };
};

/// The second point slides along a line through the first; the bodies keep their relative angle.
struct Prismatic {
  Anchor first;
  Anchor second;
  double direction = 0.0;       ///< [rad] of the line, in the first body's axes
  double relative_angle = 0.0;  ///< θ_second − θ_first [rad]
  SlideStart start;
  std::optional<JointFriction> friction = std::nullopt;

  static constexpr std::string_view kType = "prismatic";
  static constexpr std::string_view kMeaning =
      "a guide: the second point slides along a line through the first, the bodies keep their relative angle";
  static constexpr auto kFrictionFields = std::tuple{
      field("guide_length", &JointFriction::guide_length,
            friction_size(
                "L",
                "over which guide and block, the second body, touch, about the second point; 0: moments do not press")),
      field("guide_height", &JointFriction::guide_height, friction_size("h", "of the block across its guide")),
  };
  static constexpr auto kFields = std::tuple{
      field("between", &Prismatic::first, &Prismatic::second, {.required = true, .meaning = "the two points"}),
      field("direction", &Prismatic::direction,
            {.required = true, .dimension = dimension::kAngle, .meaning = "of the line, in the first body's axes"}),
      field("relative_angle", &Prismatic::relative_angle,
            {.dimension = dimension::kAngle, .meaning = "of the second body against the first"}),
      field("start", &Prismatic::start, {.meaning = "where the slide is at the start"}),
      field("friction", &Prismatic::friction,
            {.absent = "none", .meaning = "by the force and moment that the joint carries"}),
  };
};

}  // namespace gudgeon
