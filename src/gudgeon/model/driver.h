// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Drivers prescribe a motion and deliver whatever effort it takes.
#pragma once

#include <optional>
#include <string>
#include <variant>

namespace gudgeon {

/// The driven coordinate is the angle of a body against the frame.
struct DrivenAngle {
  std::string body;
};

/// The driven coordinate is the displacement of a prismatic joint.
struct DrivenSlide {
  std::string joint;
};

/// value(t) = start + speed t
struct Driver {
  std::string name;
  std::variant<DrivenAngle, DrivenSlide> target;
  double start = 0.0;  ///< [rad] or [m]
  double speed = 0.0;  ///< [rad/s] or [m/s]
};

}  // namespace gudgeon
