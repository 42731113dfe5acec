// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The ideal mechanism over its cycles: motion, efforts, dead centres, transmission angles.
#pragma once

#include "gudgeon/model/mechanism.h"
#include "gudgeon/results/kinematic_record.h"

namespace gudgeon {

struct KinematicPlan {
  double cycle_time = 1.0;  ///< [s]
  int cycles = 1;
  int samples = 360;   ///< intervals a cycle
  std::string driver;  ///< that times are given by; empty: the first
};

/// Follows the motion from t = 0. Throws ModelError when the mechanism cannot be assembled or is not driven completely;
/// where the motion cannot be followed, the record says so and keeps what was found before.
KinematicRecord run_kinematics(const Mechanism& mechanism, const KinematicPlan& plan);

}  // namespace gudgeon
