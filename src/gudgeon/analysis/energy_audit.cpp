// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The energy ledger line by line, and its verdict.
#include "gudgeon/analysis/energy_audit.h"

#include <algorithm>
#include <cmath>

namespace gudgeon {

EnergyAudit check_energy(const EnergyLedger& ledger) {
  EnergyAudit audit;
  audit.lines = {{
      {"kinetic at the end", ledger.kinetic},
      {"potential at the end", ledger.potential},
      {"elastic in contacts at the end", ledger.elastic},
      {"at the start", -ledger.initial_energy},
      {"work of the drivers", -ledger.driver_work},
      {"work of forces and torques", -ledger.load_work},
      {"lost in dampers", ledger.damper_loss},
      {"lost to contact damping", ledger.contact_damping},
      {"lost to friction", ledger.friction},
      {"work of worn surfaces", -ledger.surface_work},
  }};
  audit.residual = ledger.residual();
  audit.scale = ledger.exchanged;
  if (!(audit.scale > 0.0)) {
    for (const double held : {ledger.initial_energy, ledger.kinetic, ledger.potential, ledger.elastic}) {
      audit.scale = std::max(audit.scale, std::abs(held));
    }
  }
  audit.relative = audit.residual == 0.0 ? 0.0 : std::abs(audit.residual) / audit.scale;
  audit.closed = audit.relative <= kEnergyTolerance;
  return audit;
}

}  // namespace gudgeon
