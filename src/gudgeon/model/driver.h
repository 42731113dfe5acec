// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Drivers prescribe a motion and deliver whatever effort it takes.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "gudgeon/model/body.h"
#include "gudgeon/model/field.h"
#include "gudgeon/model/function.h"

namespace gudgeon {

/// The driven coordinate is the angle of a body, against the frame or against another body.
struct DrivenAngle {
  std::string body;
  std::string against = kFrameName;

  static constexpr std::string_view kMeaning = "a driver that turns a body";
  static constexpr Dimension kPlace = dimension::kAngle;
  static constexpr Dimension kRate = dimension::kAngularSpeed;
  static constexpr auto kFields = std::tuple{
      field("body", &DrivenAngle::body, {.required = true, .names = Names::body, .meaning = "the body it turns"}),
      field("against", &DrivenAngle::against,
            {.names = Names::body, .meaning = "the body whose axes the angle is measured from"}),
  };
};

/// The driven coordinate is the displacement of a prismatic joint.
struct DrivenSlide {
  std::string joint;

  static constexpr std::string_view kMeaning = "a driver that moves a guide";
  static constexpr Dimension kPlace = dimension::kLength;
  static constexpr Dimension kRate = dimension::kSpeed;
  static constexpr auto kFields = std::tuple{
      field("slide", &DrivenSlide::joint,
            {.required = true, .names = Names::joint, .meaning = "the prismatic joint it moves"}),
  };
};

/// value(t) = start + speed t, or the motion that is given.
struct Driver {
  std::string name;
  std::variant<DrivenAngle, DrivenSlide> target;
  double start = 0.0;  ///< [rad] or [m]
  double speed = 0.0;  ///< [rad/s] or [m/s]
  /// Of the time [rad] or [m]; takes the place of start and speed.
  std::variant<std::monostate, Expression, SampledCurve> motion = std::monostate{};

  /// Of a uniform motion; place and rate are those of what is driven.
  static constexpr auto uniform_fields(Dimension place, Dimension rate) {
    return std::tuple{
        field("start", &Driver::start,
              {.dimension = place, .absent = "that of the body or joint, else 0", .meaning = "where it is at t = 0"}),
        field("speed", &Driver::speed,
              {.required = true, .unless = "motion", .dimension = rate, .meaning = "the same throughout"}),
    };
  }
  /// Of any other.
  static constexpr std::string_view kMotionKey = "motion";
  static constexpr std::string_view kMotionMeaning =
      "where it is, as a function of the time; takes the place of start and speed";

  [[nodiscard]] bool is_uniform() const { return std::holds_alternative<std::monostate>(motion); }
};

}  // namespace gudgeon
