// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The energy balance line by line, and its verdict.
#include "gudgeon/analysis/energy_audit.h"

#include <fmt/format.h>

#include <cmath>

namespace gudgeon {

EnergyAudit check_energy(const EnergyBalance& balance) {
  EnergyAudit audit;
  audit.lines = {{
      {"kinetic at the end", balance.kinetic},
      {"potential at the end", balance.potential},
      {"elastic in contacts at the end", balance.elastic},
      {"at the start", -balance.initial_energy},
      {"work of the drivers", -balance.driver_work},
      {"work of forces and torques", -balance.load_work},
      {"lost in dampers", balance.damper_loss},
      {"lost to contact damping", balance.contact_damping},
      {"lost to friction", balance.friction},
      {"work of worn surfaces", -balance.surface_work},
  }};
  audit.residual = balance.residual();
  audit.exchanged = balance.exchanged;
  audit.scale = find_energy_scale(balance);
  audit.relative = audit.residual == 0.0 ? 0.0 : std::abs(audit.residual) / audit.scale;
  audit.balanced = is_balanced(balance);
  return audit;
}

bool is_unbalanced(const StageRecord& stage) {
  return stage.status == StageStatus::finished && !is_balanced(stage.energy);
}

std::string explain_imbalance(const StageRecord& stage) {
  if (!is_unbalanced(stage)) return {};
  const EnergyAudit audit = check_energy(stage.energy);
  return fmt::format(
      "E-NUM-020: its energy balance does not close: the residual is {:.3g} J, {:.1e} of the energy exchanged and "
      "held, more "
      "than {:.0e}; lower study.relative_tolerance",
      audit.residual, audit.relative, kEnergyTolerance);
}

}  // namespace gudgeon
