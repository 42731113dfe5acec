// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A planar mechanism as the user describes it: bodies, joints, drivers, loads, gravity.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/model/body.h"
#include "gudgeon/model/driver.h"
#include "gudgeon/model/field.h"
#include "gudgeon/model/joint.h"
#include "gudgeon/model/load.h"

namespace gudgeon {

struct Mechanism {
  std::string name;
  std::string description;
  Vec2 gravity;              ///< g [m/s^2] in the frame's axes; none unless given
  std::vector<Body> bodies;  ///< the frame is bodies[0]; its mass is not used
  std::vector<Joint> joints;
  std::vector<Driver> drivers;
  std::vector<Load> loads;

  /// Besides its sections.
  static constexpr std::string_view kMeaning = "the mechanism";
  static constexpr auto kFields = std::tuple{
      field("name", &Mechanism::name, {.required = true, .meaning = "of the model; run files are called by it"}),
      field("description", &Mechanism::description, {.meaning = "what it is"}),
      field("gravity", &Mechanism::gravity,
            {.dimension = dimension::kAcceleration, .symbol = "g", .meaning = "x and y, in the frame's axes"}),
  };
};

/// Index of the body of that name, or -1.
int find_body(const Mechanism& mechanism, std::string_view name);
/// Index of the joint of that name, or -1.
int find_joint(const Mechanism& mechanism, std::string_view name);
/// The point of that name on a body; nullptr when there is none.
const Point* find_point(const Body& body, std::string_view name);

/// The same mechanism with every clearance joint replaced by its ideal counterpart.
Mechanism make_ideal(const Mechanism& mechanism);

/// The same, with the friction laws of the contacts that are replaced, at the sizes of their journals; bristles only
/// where find_bristled_slot() finds none.
Mechanism make_ideal_with_friction(const Mechanism& mechanism);
/// The first pin in a slot with clearance whose friction law has bristles, which an ideal one cannot have; or -1.
int find_bristled_slot(const Mechanism& mechanism);

/// Takes the friction of all ideal joints away.
void remove_friction(Mechanism& mechanism);

}  // namespace gudgeon
