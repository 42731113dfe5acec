// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Two bodies as one.
#pragma once

#include "gudgeon/model/field.h"
#include "gudgeon/model/joint/anchor.h"

namespace gudgeon {

/// The two points coincide and the bodies keep their relative angle.
struct Rigid {
  Anchor first;
  Anchor second;
  double relative_angle = 0.0;  ///< θ_second − θ_first [rad]

  static constexpr std::string_view kType = "rigid";
  static constexpr std::string_view kMeaning = "two points coincide, the bodies keep their relative angle";
  static constexpr auto kFields = std::tuple{
      field("between", &Rigid::first, &Rigid::second, {.required = true, .meaning = "the two points"}),
      field("relative_angle", &Rigid::relative_angle,
            {.dimension = dimension::kAngle, .meaning = "of the second body against the first"}),
  };
};

}  // namespace gudgeon
