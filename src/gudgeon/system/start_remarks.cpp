// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One remark a body.
#include "gudgeon/system/start_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gudgeon {

namespace {

bool is_driven(const Mechanism& mechanism, const Body& body) {
  return std::ranges::any_of(mechanism.drivers, [&](const Driver& driver) {
    const auto* angle = std::get_if<DrivenAngle>(&driver.target);
    return angle != nullptr && angle->body == body.name;
  });
}

}  // namespace

Diagnostics remark_held_angles(const Mechanism& mechanism, const Assembly& assembly) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;  // [deg/rad]
  Diagnostics diagnostics;
  for (const int b : assembly.held_bodies) {
    const Body& body = mechanism.bodies[b];
    if (is_driven(mechanism, body)) continue;
    const double given = *body.start.angle;
    diagnostics.remark(
        "R-MODEL-110", "bodies." + body.name + ".start.angle",
        fmt::format("body '{}': its start angle is {:.6g} deg, and it starts at {:.6g} deg", body.name,
                    kDegrees * given, kDegrees * (given + assembly.angle_changes[b])),
        {"its joints, a slot taken as an ideal guide among them, or a body tied to it leave it no other angle"});
  }
  return diagnostics;
}

}  // namespace gudgeon
