// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How the journals of a stage spend their time: in flight, in impacts, in lasting contact.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// A stay in contact is called lasting when it takes longer than this part of a cycle, an impact otherwise: impacts
/// of metal on metal take tenths of a millisecond, lasting contact follows the motion of the mechanism.
inline constexpr double kLastingFraction = 0.01;

struct JointContactSummary {
  std::string joint;
  std::int64_t onsets = 0;
  double contact_fraction = 0.0;  ///< [1] of the stage's time
  double flight_fraction = 0.0;   ///< [1] the rest
  double lasting_fraction = 0.0;  ///< [1] of the time in contact, spent in lasting contacts
  double impact_fraction = 0.0;   ///< [1] of the time in contact, spent in impacts
  double mean_force = 0.0;        ///< [N] while in contact
  double largest_force = 0.0;     ///< [N]
};

/// One summary a clearance joint, over the counted cycles.
std::vector<JointContactSummary> summarize_contacts(const StageRecord& stage);

}  // namespace gudgeon
