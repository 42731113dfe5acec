// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A contact that wears under a constant load.
#pragma once

#include <cmath>

#include "gudgeon/sim/wear_accumulator.h"

namespace gudgeon {

inline constexpr double kCoefficient = 8e-14;  // k_d [1/Pa]

inline Contact make_worn_contact() {
  Contact contact;
  contact.surfaces = RevoluteSurfaces{15e-3, 14.5e-3, {}, {}};
  contact.width = 20e-3;
  contact.bearing_wear = Archard{0.75 * kCoefficient};
  contact.journal_wear = Archard{0.25 * kCoefficient};
  return contact;
}

// A contact at one direction, with a constant load.
inline ContactSample make_worn_sample(double direction) {
  ContactSample sample;
  sample.normal = {std::cos(direction), std::sin(direction)};
  sample.bearing_radius = 15e-3;
  sample.journal_radius = 14.5e-3;
  sample.penetration = 7.3e-6;
  sample.normal_force = 640.0;
  sample.slip_speed = -0.31;
  return sample;
}

}  // namespace gudgeon
