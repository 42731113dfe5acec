// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A pin without clearance.
#pragma once

#include <optional>

#include "gudgeon/model/field.h"
#include "gudgeon/model/joint/anchor.h"
#include "gudgeon/model/joint/friction.h"
#include "gudgeon/model/joint/size_of_joint.h"

namespace gudgeon {

/// The two points coincide; the bodies turn freely.
struct Revolute {
  Anchor first;
  Anchor second;
  std::optional<JointFriction> friction = std::nullopt;

  static constexpr std::string_view kType = "revolute";
  static constexpr std::string_view kMeaning = "a pin: two points coincide, the bodies turn freely";
  static constexpr auto kFrictionFields = std::tuple{
      field("pin_radius", &JointFriction::pin_radius, size_of_joint("r", "of the pin")),
  };
  static constexpr auto kFields = std::tuple{
      field("between", &Revolute::first, &Revolute::second, {.required = true, .meaning = "the two points"}),
      field("friction", &Revolute::friction, {.absent = "none", .meaning = "by the force that the joint carries"}),
  };
};

}  // namespace gudgeon
