// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A guide with clearance.
#pragma once

#include "gudgeon/model/contact.h"
#include "gudgeon/model/joint/prismatic.h"
#include "gudgeon/model/joint/size_of_joint.h"

namespace gudgeon {

/// A guide with clearance: a block, the journal, slides, tilts and knocks between the two sides of a slot, the bearing.
/// Each of its four rounded corners touches the side it faces. Without clearance it is a Prismatic.
struct PrismaticClearance {
  Anchor bearing;               ///< the middle of the slot
  Anchor journal;               ///< the middle of the block
  double direction = 0.0;       ///< [rad] of the slot, in the bearing's body
  double relative_angle = 0.0;  ///< [rad] θ_journal − θ_bearing at which the block lies along the slot
  double bearing_length = 0.0;  ///< [m] of the slot
  double journal_length = 0.0;  ///< [m] of the block, along the slot
  double journal_height = 0.0;  ///< [m] of the block, across the slot
  double corner_radius = 0.0;   ///< R_j [m] of the block's corners
  double clearance = 0.0;       ///< c [m] on either side: the slot is journal_height + 2 c wide
  double width = 0.0;           ///< w [m] along the axis
  ContactProperties contact;

  static constexpr std::string_view kType = "prismatic_clearance";
  static constexpr std::string_view kMeaning =
      "a guide with clearance: a block with four rounded corners slides, tilts and knocks between the sides of a slot";
  static constexpr auto kFields = std::tuple{
      field("bearing", &PrismaticClearance::bearing, {.required = true, .meaning = "the middle of the slot"}),
      field("journal", &PrismaticClearance::journal, {.required = true, .meaning = "the middle of the block"}),
      field("direction", &PrismaticClearance::direction,
            {.required = true, .dimension = dimension::kAngle, .meaning = "of the slot, in the bearing's axes"}),
      field("relative_angle", &PrismaticClearance::relative_angle,
            {.dimension = dimension::kAngle,
             .meaning = "of the journal against the bearing when the block lies along the slot"}),
      field("bearing_length", &PrismaticClearance::bearing_length, size_of_joint("", "of the slot")),
      field("journal_length", &PrismaticClearance::journal_length, size_of_joint("", "of the block, along the slot")),
      field("journal_height", &PrismaticClearance::journal_height, size_of_joint("", "of the block, across the slot")),
      field("corner_radius", &PrismaticClearance::corner_radius, size_of_joint("R_j", "of the block's corners")),
      field("clearance", &PrismaticClearance::clearance, size_of_joint("c", "on either side of the block")),
      field("width", &PrismaticClearance::width, size_of_joint("w", "along the axis")),
      field("contact", &PrismaticClearance::contact, {.required = true, .meaning = "of slot and block"}),
  };

  [[nodiscard]] double play() const { return clearance; }
  [[nodiscard]] Prismatic make_ideal() const { return {bearing, journal, direction, relative_angle, {}}; }
  /// Of the ideal counterpart that rubs as the contact does: between the block's outer points of contact.
  [[nodiscard]] JointFriction make_friction() const {
    return {contact.friction, 0.0, journal_length - 2.0 * corner_radius, journal_height};
  }
};

}  // namespace gudgeon
