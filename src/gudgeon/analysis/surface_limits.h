// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Penetrations and depths of wear that no bearing has.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// What a contact went beyond.
enum class SurfaceLimit {
  penetration_radius,  ///< the journal went deeper into its bearing than the bearing's radius; in a slot, than its own
  wear_radius,         ///< the bearing is worn deeper than its radius: hardly a wall is as thick
  wear_clearance,      ///< a surface is worn deeper than the clearance
};

struct LimitExceeded {
  std::string stage;
  std::string joint;
  SurfaceLimit limit = SurfaceLimit::penetration_radius;
  double reached = 0.0;     ///< [m]
  double bound = 0.0;       ///< [m]
  bool of_journal = false;  ///< the journal's surface or radius, not the bearing's
};

/// In the order of stages and joints; penetrations are those of the counted cycles.
std::vector<LimitExceeded> find_limits_exceeded(const RunRecord& run);

/// What was met and what it means, in a sentence.
std::string describe(const LimitExceeded& exceeded);

}  // namespace gudgeon
