// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What may be missing from a stage's energy (docs/theory/energy.md, Eq. E4).
#pragma once

#include <cmath>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// The books are closed when the residual is below this part of find_energy_scale(): some ten times what local errors
/// at the default tolerance add up to, and far below any term one would look at.
inline constexpr double kEnergyTolerance = 1e-6;

/// What the residual is measured by [J]: the energy exchanged, and what energies that were there throughout can be
/// known to. Speeds are known to 1e-7 where steps are held by the energy balance, and a kinetic energy to twice that;
/// sums of some thousand terms are rounded to 1e-12, energies as well as places, over which loads work.
inline double find_energy_scale(const EnergyBalance& balance) {
  constexpr double kSpeedsKnown = 1e-7;
  constexpr double kSumsKnown = 1e-12;
  const double held =
      std::abs(balance.initial_energy) + balance.kinetic + std::abs(balance.potential) + std::abs(balance.elastic);
  const double rounded = kSumsKnown * (held + balance.load_reach);
  return balance.exchanged + (2.0 * kSpeedsKnown * balance.kinetic + rounded) / kEnergyTolerance;
}

/// The largest residual [J] with which the energy adds up.
inline double find_allowed_residual(const EnergyBalance& balance) {
  return kEnergyTolerance * find_energy_scale(balance);
}

/// Not where any term is no number.
inline bool is_balanced(const EnergyBalance& balance) {
  return std::abs(balance.residual()) <= find_allowed_residual(balance);
}

}  // namespace gudgeon
