// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Drivers prescribe a motion and deliver whatever effort it takes.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "gudgeon/model/body.h"
#include "gudgeon/model/function.h"

namespace gudgeon {

/// The driven coordinate is the angle of a body, against the frame or against another body.
struct DrivenAngle {
  std::string body;
  std::string against = kFrameName;
};

/// The driven coordinate is the displacement of a prismatic joint.
struct DrivenSlide {
  std::string joint;
};

/// value(t) = start + speed t, or the motion that is given.
struct Driver {
  std::string name;
  std::variant<DrivenAngle, DrivenSlide> target;
  double start = 0.0;  ///< [rad] or [m]
  double speed = 0.0;  ///< [rad/s] or [m/s]
  /// Of the time [rad] or [m]; takes the place of start and speed.
  std::variant<std::monostate, Expression, SampledCurve> motion = std::monostate{};

  [[nodiscard]] bool is_uniform() const { return std::holds_alternative<std::monostate>(motion); }
};

}  // namespace gudgeon
