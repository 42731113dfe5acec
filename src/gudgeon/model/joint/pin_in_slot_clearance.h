// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A pin in a slot with clearance.
#pragma once

#include "gudgeon/model/contact.h"
#include "gudgeon/model/joint/pin_in_slot.h"
#include "gudgeon/model/joint/size_of_joint.h"

namespace gudgeon {

/// A pin, the journal, in a slot that is wider than it, the bearing. Without clearance it is a PinInSlot.
struct PinInSlotClearance {
  Anchor bearing;               ///< the middle of the slot
  Anchor journal;               ///< the centre of the pin
  double direction = 0.0;       ///< [rad] of the slot, in the bearing's body
  double bearing_length = 0.0;  ///< [m] of the slot
  double journal_radius = 0.0;  ///< R_j [m]
  double clearance = 0.0;       ///< c [m] on either side: the slot is 2 (R_j + c) wide
  double width = 0.0;           ///< w [m] along the axis
  ContactProperties contact;

  static constexpr std::string_view kType = "pin_in_slot_clearance";
  static constexpr std::string_view kMeaning = "a pin in a slot that is wider than it";
  static constexpr auto kFields = std::tuple{
      field("bearing", &PinInSlotClearance::bearing, {.required = true, .meaning = "the middle of the slot"}),
      field("journal", &PinInSlotClearance::journal, {.required = true, .meaning = "the centre of the pin"}),
      field("direction", &PinInSlotClearance::direction,
            {.required = true, .dimension = dimension::kAngle, .meaning = "of the slot, in the bearing's axes"}),
      field("bearing_length", &PinInSlotClearance::bearing_length, size_of_joint("", "of the slot")),
      field("journal_radius", &PinInSlotClearance::journal_radius, size_of_joint("R_j", "of the pin")),
      field("clearance", &PinInSlotClearance::clearance, size_of_joint("c", "on either side of the pin")),
      field("width", &PinInSlotClearance::width, size_of_joint("w", "along the axis")),
      field("contact", &PinInSlotClearance::contact, {.required = true, .meaning = "of slot and pin"}),
  };

  [[nodiscard]] double play() const { return clearance; }
  [[nodiscard]] PinInSlot make_ideal() const { return {bearing, journal, direction}; }
  /// Of the ideal counterpart that rubs as the contact does: on the pin.
  [[nodiscard]] JointFriction make_friction() const { return {contact.friction, journal_radius, 0.0, 0.0}; }
};

}  // namespace gudgeon
