// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The energy ledger line by line, and its verdict.
#include "gudgeon/analysis/energy_audit.h"

#include <fmt/format.h>

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
  audit.exchanged = ledger.exchanged;
  audit.scale = find_energy_scale(ledger);
  audit.relative = audit.residual == 0.0 ? 0.0 : std::abs(audit.residual) / audit.scale;
  audit.closed = is_closed(ledger);
  return audit;
}

bool is_unbalanced(const StageRecord& stage) {
  return stage.status == StageStatus::finished && !is_closed(stage.ledger);
}

std::string explain_imbalance(const StageRecord& stage) {
  if (!is_unbalanced(stage)) return {};
  const EnergyAudit audit = check_energy(stage.ledger);
  return fmt::format(
      "E-NUM-020: its energy does not add up: the residual is {:.3g} J, {:.1e} of the energy exchanged and held, more "
      "than {:.0e}; lower study.relative_tolerance",
      audit.residual, audit.relative, kEnergyTolerance);
}

}  // namespace gudgeon
