// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What all bodies of a run have together.
#pragma once

#include <array>

#include "gudgeon/model/mechanism.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Momentum along x and y [N s] and angular momentum about the frame's origin [N m s] at one sample.
inline std::array<double, 3> find_momenta(const Mechanism& mechanism, const StageRecord& stage, std::size_t k) {
  std::array<double, 3> momenta{};
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    const auto at = [&](const char* ending) { return find_values(stage, body.name + ending)->at(k); };
    const Vec2 momentum = body.mass * Vec2{at(".x_velocity"), at(".y_velocity")};
    momenta[0] += momentum.x;
    momenta[1] += momentum.y;
    momenta[2] += cross({at(".x"), at(".y")}, momentum) + body.inertia * at(".angle_rate");
  }
  return momenta;
}

}  // namespace gudgeon
