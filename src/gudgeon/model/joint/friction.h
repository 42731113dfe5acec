// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Friction of joints without clearance.
#pragma once

#include "gudgeon/laws/friction/any.h"
#include "gudgeon/model/field.h"

namespace gudgeon {

/// A size that may be zero; a joint that can have friction has a table of them, kFrictionFields.
constexpr FieldTraits friction_size(std::string_view symbol, std::string_view meaning) {
  return {.dimension = dimension::kLength,
          .symbol = symbol,
          .range = kNotNegative,
          .code = "E-MODEL-012",
          .meaning = meaning};
}

/// Friction in an ideal joint, by a law and what the force that the joint carries acts on (docs/theory/friction.md).
struct JointFriction {
  AnyFriction law;
  double pin_radius = 0.0;    ///< r [m] of the pin of a revolute joint, or of a pin in a slot
  double guide_length = 0.0;  ///< L [m] over which block and guide touch, about the second point; 0: moments do not rub
  double guide_height = 0.0;  ///< h [m] of the block across its guide
};

}  // namespace gudgeon
