// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Does the energy of a stage add up?
#pragma once

#include <array>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// The books are closed when the residual is below this part of the energy exchanged: some ten times what local
/// errors at the default tolerance of 1e-7 add up to, and far below any term one would look at.
inline constexpr double kEnergyTolerance = 1e-6;

/// One line of the ledger as it enters the sum, which would be zero in exact arithmetic.
struct EnergyLine {
  const char* meaning = "";
  double value = 0.0;  ///< [J] signed: now − start − given + lost
};

struct EnergyAudit {
  std::array<EnergyLine, 10> lines;
  double residual = 0.0;  ///< [J] sum of the lines
  double scale = 0.0;     ///< [J] energy exchanged; where nothing was, the largest energy held
  double relative = 0.0;  ///< [1] |residual| / scale
  bool closed = false;    ///< relative is at most kEnergyTolerance
};

EnergyAudit check_energy(const EnergyLedger& ledger);

}  // namespace gudgeon
