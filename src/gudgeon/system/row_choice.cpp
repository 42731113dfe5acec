// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Shares by one solve a row, and tables compiled anew for another choice.
#include "gudgeon/system/row_choice.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/system/characteristic_length.h"
#include "gudgeon/system/closure_entries.h"

namespace gudgeon {

namespace {

// Rows are exchanged for a gain in volume beyond this. Gaps of rows that are not enforced are then at most so many
// times those of the others, and the rows do not change to and fro: what was gained must be lost twice over.
constexpr double kWorthwhile = 8.0;

ActiveRows list_active(const Tables& tables) {
  ActiveRows active;
  for (const ClosureRows& rows : tables.closures) active.push_back({rows.active[0], rows.active[1]});
  return active;
}

void enforce(const ActiveRows& active, System& system) {
  Tables tables = compile_tables(system.mechanism, system.topology, &active);
  // Worn surfaces and the way that they have slid stay where they are.
  tables.contacts = std::move(system.tables.contacts);
  system.tables = std::move(tables);
}

}  // namespace

void transfer_rows(StateArchive& archive, System& system) {
  ActiveRows active = list_active(system.tables);
  archive(active);
  if (active != list_active(system.tables)) enforce(active, system);
  archive.list(system.tables.usual_pivots);
}

bool has_free_rows(const Tables& tables) {
  return std::ranges::any_of(tables.closures, [](const ClosureRows& rows) {
    return !rows.active[0] || (count_rows(rows.kind) == 2 && !rows.active[1]);
  });
}

void note_usual_pivots(Tables& tables, const Workspace& workspace) {
  tables.usual_pivots.resize(workspace.inverse_pivots.size());
  std::ranges::transform(workspace.inverse_pivots, tables.usual_pivots.begin(),
                         [](double inverse) { return 1.0 / inverse; });
}

RowChoice::RowChoice(const System& system)
    : length_(find_characteristic_length(system.mechanism)),
      shares_(static_cast<std::size_t>(system.tables.n_indices)) {}

// H x + J_aᵀ c = J_dᵀ, J_a x = 0.
void RowChoice::find_shares(const Tables& tables, const Workspace& workspace, Row row) {
  std::ranges::fill(shares_, 0.0);
  visit_closure_entries(tables, workspace.coordinates, tables.closures[row.closure],
                        [&](int k, int index, double value) {
                          if (k == row.row && index < tables.counts.n_free()) shares_[index] += value;
                        });
  tables.elimination.solve(workspace.values.data(), workspace.inverse_pivots.data(), shares_.data());
}

std::optional<RowChoice::Exchange> RowChoice::find_exchange(const Tables& tables, const Workspace& workspace) {
  const auto find_unit = [&](int c) { return tables.closures[c].kind == ClosureKind::angle ? 1.0 : length_; };
  std::optional<Exchange> best;
  double most = kWorthwhile;
  const int n_closures = static_cast<int>(tables.closures.size());
  for (int d = 0; d < n_closures; ++d) {
    for (int k = 0; k < count_rows(tables.closures[d].kind); ++k) {
      if (tables.closures[d].active[k]) continue;
      find_shares(tables, workspace, {d, k});
      for (int c = 0; c < n_closures; ++c) {
        for (int row = 0; row < 2; ++row) {
          if (!tables.closures[c].active[row]) continue;
          const double share = std::abs(shares_[tables.closures[c].row[row]]) * find_unit(c) / find_unit(d);
          if (share > most && std::isfinite(share)) most = share, best = {{c, row}, {d, k}};
        }
      }
    }
  }
  return best;
}

bool RowChoice::update(System& system, Workspace& workspace) {
  const std::optional<Exchange> exchange = find_exchange(system.tables, workspace);
  if (!exchange) return false;
  ActiveRows active = list_active(system.tables);
  active[exchange->out.closure][exchange->out.row] = false;
  active[exchange->in.closure][exchange->in.row] = true;
  enforce(active, system);
  workspace.fit(system.tables);
  return true;
}

}  // namespace gudgeon
