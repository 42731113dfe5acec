// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which of the closure rows that depend on each other are enforced, position after position.
#pragma once

#include <optional>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/system/system.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Enforced rows may lose their independence while all rows together keep their rank. A row d that is not enforced is a
/// sum of those that are, J_d = Σ c_i J_i; with d in the place of i the volume of the enforced rows is |c_i| times as
/// large. Exchanged where that is a great deal, the rows stay nearly as independent as any choice of them.
class RowChoice {
 public:
  /// For a system with rows that are not enforced.
  explicit RowChoice(const System& system);

  /// Exchanges two rows of the system, if need be, for the position that the workspace was last evaluated at, and fits
  /// the workspace. True where it did: the state is then to be evaluated again before the next call.
  bool update(System& system, Workspace& workspace);

 private:
  struct Row {
    int closure = 0;
    int row = 0;
  };
  struct Exchange {
    Row out;
    Row in;
  };

  [[nodiscard]] std::optional<Exchange> find_exchange(const Tables& tables, const Workspace& workspace);
  void find_shares(const Tables& tables, const Workspace& workspace, Row row);

  double length_;               // [m] beside which angles are measured
  std::vector<double> shares_;  // c of each enforced row, by its index
};

/// Saves the rows that are enforced and their usual pivots, or has the system enforce those that were saved.
void transfer_rows(StateArchive& archive, System& system);

/// Whether any row of a closure is not enforced.
bool has_free_rows(const Tables& tables);

/// Notes the pivots of the workspace's last evaluation as the usual ones.
void note_usual_pivots(Tables& tables, const Workspace& workspace);

}  // namespace gudgeon
