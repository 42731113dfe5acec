// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A wheel under a brake shoe: the plainest mechanism in which a clearance joint slides under a constant normal force.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanism_parts.h"

namespace gudgeon {

/// The shoe is a bearing around the wheel, guided upright and pressed down on it. Slip and friction at the wheel's rim
/// are those of a block of the same mass on a level floor: rim speed = wheel.angle_rate, at 1 m from its centre.
struct Brake {
  double mass = 1.0;          ///< [kg] of the block: inertia of the wheel [kg m²]
  double normal_force = 1.0;  ///< [N]
  double speed = 0.0;         ///< [m/s] of the rim at the start
  AnyFriction friction;
};

inline constexpr double kBrakeStiffness = 1e6;   // [N/m]
inline constexpr double kBrakeShoeMass = 0.01;   // [kg]
inline constexpr double kBrakeClearance = 1e-6;  // [m]

/// The shoe starts one clearance off the wheel, met within a millisecond. Its contact is critically damped, so that it
/// is at rest within some milliseconds: rate 10 000/s.
inline Mechanism make_brake(const Brake& brake) {
  // Friction acts in the middle of the overlap.
  const double overlap = brake.normal_force / kBrakeStiffness;
  const double journal_radius = 1.0 + 0.5 * overlap;
  Mechanism mechanism = oracle::make_empty("brake", {}, {{"axle", {0.0, 0.0}}});
  mechanism.bodies.push_back(
      {"wheel", 1.0, brake.mass, {}, {{"axle", {0.0, 0.0}}}, oracle::start_turning(0.0, brake.speed)});
  mechanism.bodies.push_back({"shoe", kBrakeShoeMass, 1e-3, {}, {{"bore", {0.0, 0.0}}}, {}});
  oracle::add_revolute(mechanism, "axle", {kFrameName, "axle"}, {"wheel", "axle"});
  mechanism.joints.push_back(
      {"guide", oracle::make_slide({kFrameName, "axle"}, {"shoe", "bore"}, 0.5 * std::numbers::pi, 0.0, 0.0)});
  const Material any{"any", 1e9, 0.3};
  KelvinVoigt pad;
  pad.stiffness = kBrakeStiffness;
  pad.damping = 2.0 * std::sqrt(kBrakeStiffness * kBrakeShoeMass);
  mechanism.joints.push_back({"pad", RevoluteClearance{{"shoe", "bore"},
                                                       {"wheel", "axle"},
                                                       journal_radius + kBrakeClearance,
                                                       kBrakeClearance,
                                                       0.1,
                                                       ContactProperties{"pad", any, any, pad, brake.friction}}});
  mechanism.loads.push_back({"press", ConstantForce{{"shoe", "bore"}, {0.0, -brake.normal_force}}});
  return mechanism;
}

}  // namespace gudgeon
