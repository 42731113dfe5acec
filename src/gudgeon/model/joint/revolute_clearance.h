// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A pin with clearance.
#pragma once

#include "gudgeon/model/contact.h"
#include "gudgeon/model/joint/revolute.h"
#include "gudgeon/model/joint/size_of_joint.h"

namespace gudgeon {

/// A revolute joint with clearance: the journal of one body moves and hits inside the bearing of the other.
struct RevoluteClearance {
  Anchor bearing;
  Anchor journal;
  double bearing_radius = 0.0;    ///< R_i [m]
  double radial_clearance = 0.0;  ///< c = R_i − R_j [m]
  double width = 0.0;             ///< w [m] along the axis
  ContactProperties contact;

  static constexpr std::string_view kType = "revolute_clearance";
  static constexpr std::string_view kMeaning = "a pin with clearance: a journal moves and hits inside a bearing";
  static constexpr auto kFields = std::tuple{
      field("bearing", &RevoluteClearance::bearing, {.required = true, .meaning = "centre of the bearing"}),
      field("journal", &RevoluteClearance::journal, {.required = true, .meaning = "centre of the journal"}),
      field("bearing_radius", &RevoluteClearance::bearing_radius, size_of_joint("R_i", "of the bearing")),
      field("radial_clearance", &RevoluteClearance::radial_clearance,
            size_of_joint("c", "by which the journal's radius is smaller")),
      field("width", &RevoluteClearance::width, size_of_joint("w", "along the axis")),
      field("contact", &RevoluteClearance::contact, {.required = true, .meaning = "of bearing and journal"}),
  };

  [[nodiscard]] double play() const { return radial_clearance; }
  [[nodiscard]] Revolute make_ideal() const { return {bearing, journal}; }
  /// Of the ideal counterpart that rubs as the contact does: on the pin.
  [[nodiscard]] JointFriction make_friction() const {
    return {contact.friction, bearing_radius - radial_clearance, 0.0, 0.0};
  }
};

}  // namespace gudgeon
