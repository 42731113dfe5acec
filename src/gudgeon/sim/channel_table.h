// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every channel of a system beside the function that reads it: one table, one order.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "gudgeon/results/channel.h"
#include "gudgeon/sim/clearance_reading.h"
#include "gudgeon/system/reactions.h"

namespace gudgeon {

/// One state of a stage with all that channels are read from.
struct Snapshot {
  const Workspace* workspace = nullptr;
  std::span<const ContactMode> contact_modes;
  const std::vector<BodyMotion>* motions = nullptr;
  const std::vector<JointReaction>* reactions = nullptr;
  std::vector<ClearanceReading> clearances;  ///< one a clearance joint
  double kinetic = 0.0;                      ///< [J]
  double potential = 0.0;
  double elastic = 0.0;
  double initial_energy = 0.0;        ///< [J] of the stage's start
  const double* integrals = nullptr;  ///< one an EnergyIntegral
};

struct RecordedChannel {
  Channel channel;
  std::function<double(const Snapshot&)> read;
  bool watched =
      false;  ///< its statistics are taken at every step: reads no reactions, energies, contact modes or positions
};

std::vector<RecordedChannel> make_channel_table(const System& system);

}  // namespace gudgeon
