// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A pin in a slot without clearance.
#pragma once

#include <optional>

#include "gudgeon/model/field.h"
#include "gudgeon/model/joint/anchor.h"
#include "gudgeon/model/joint/friction.h"

namespace gudgeon {

/// The second point stays on a line through the first; the bodies turn freely.
struct PinInSlot {
  Anchor first;
  Anchor second;
  double direction = 0.0;  ///< [rad] of the line, in the first body's axes
  std::optional<JointFriction> friction = std::nullopt;

  static constexpr std::string_view kType = "pin_in_slot";
  static constexpr std::string_view kMeaning =
      "a pin in a slot: the second point stays on a line through the first, the bodies turn freely";
  static constexpr auto kFrictionFields = std::tuple{
      field("pin_radius", &JointFriction::pin_radius, friction_size("r", "of the pin")),
  };
  static constexpr auto kFields = std::tuple{
      field("between", &PinInSlot::first, &PinInSlot::second,
            {.required = true, .meaning = "a point of the slot, and the pin"}),
      field("direction", &PinInSlot::direction,
            {.required = true, .dimension = dimension::kAngle, .meaning = "of the slot, in the first body's axes"}),
      field("friction", &PinInSlot::friction, {.absent = "none", .meaning = "by the force that the joint carries"}),
  };
};

}  // namespace gudgeon
