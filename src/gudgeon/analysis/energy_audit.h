// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Does the energy of a stage add up?
#pragma once

#include <array>
#include <string>

#include "gudgeon/results/energy_balance.h"

namespace gudgeon {

/// One line of the energy balance as it enters the sum, which would be zero in exact arithmetic.
struct EnergyLine {
  const char* meaning = "";
  double value = 0.0;  ///< [J] signed: end − start − supplied + dissipated
};

struct EnergyAudit {
  std::array<EnergyLine, 10> lines;
  double residual = 0.0;   ///< [J] sum of the lines
  double exchanged = 0.0;  ///< [J]
  double scale = 0.0;      ///< [J] what it is measured by, find_energy_scale()
  double relative = 0.0;   ///< [1] |residual| / scale
  bool balanced = false;   ///< relative is at most kEnergyTolerance
};

EnergyAudit check_energy(const EnergyBalance& balance);

/// Whether the stage finished and its energy balance does not close: its numbers are not to be relied on.
bool is_unbalanced(const StageRecord& stage);

/// What to tell of an unbalanced stage: by how much, and what to do. Empty for any other.
std::string explain_imbalance(const StageRecord& stage);

}  // namespace gudgeon
