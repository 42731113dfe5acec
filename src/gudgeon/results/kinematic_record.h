// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a kinematic analysis found: plain data.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// When something happens: the time, and where the driver is then.
struct DriverTime {
  double time = 0.0;          ///< [s]
  double driver_value = 0.0;  ///< [rad] or [m]
};

/// A limit position: a body's angle or a slide's displacement turns back.
struct DeadCentre {
  std::string of;    ///< "rocker" or "guide"
  std::string unit;  ///< "rad" or "m"
  DriverTime at;     ///< located by root finding
  double value = 0.0;
  bool is_greatest = false;  ///< the value grows before and falls after
};

/// Least and greatest transmission angle of a loop, or pressure angle where a guide is part of it [rad].
struct TransmissionRange {
  std::string joint;
  bool is_pressure_angle = false;
  double least = 0.0;
  DriverTime least_at;
  double greatest = 0.0;
  DriverTime greatest_at;
};

/// A loop that folds to the other side from here on.
struct BranchChange {
  std::string joint;
  DriverTime at;
  bool to_left = false;  ///< from right to left, or the other way
};

struct KinematicRecord {
  StageRecord motion;  ///< channels of a run, "SLIDE.displacement" …, "DRIVER.value", "JOINT.transmission_angle" …
  std::string driver;  ///< that times are given by; empty without drivers
  std::string driver_unit;    ///< "rad" or "m"
  double failure_time = 0.0;  ///< [s] when motion.status is failed
  std::vector<DeadCentre> dead_centres;
  std::vector<TransmissionRange> transmissions;
  std::vector<BranchChange> branch_changes;
};

}  // namespace gudgeon
