// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a run would meet first, found without one.
#include "gudgeon/system/start_check.h"

#include <fmt/format.h>

#include <cmath>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/loose_start.h"
#include "gudgeon/system/mobility.h"
#include "gudgeon/system/motion_chart.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

namespace {

void require_regular(const Mechanism& mechanism, const Assembly& assembly) {
  if (!find_mobility(mechanism, assembly).singular_start) return;
  Diagnostics diagnostics;
  diagnostics.error("E-MODEL-073", "",
                    "the mechanism starts in a singular position, where its motion is not determined",
                    {"start a little beside it: change a start angle or a driver's start"});
  throw ModelError(diagnostics);
}

// The first coordinate whose own pivot vanished; what is eliminated after it is spoilt, too.
int find_massless(const System& system, const Workspace& workspace) {
  for (int k = 0; k < system.tables.counts.n_free(); ++k) {
    const int at = system.tables.elimination.find_slot(k, k);
    if (!std::isfinite(workspace.inverse_pivots[at])) return k;
  }
  return -1;
}

void require_accelerations(const Mechanism& mechanism, const Assembly& assembly) {
  const System system = compile(mechanism, assembly);
  Workspace workspace(system.tables);
  const State state = make_state(system, assembly);
  const std::vector<ContactMode> open(system.tables.contacts.size());
  eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), open, {}, workspace);
  bool determined = true;
  for (int k = 0; k < system.tables.counts.n_free(); ++k) {
    determined = determined && std::isfinite(workspace.equations[k]);
  }
  if (determined) return;
  Diagnostics diagnostics;
  const int massless = find_massless(system, workspace);
  const std::string name = massless >= 0 ? name_coordinate(system, massless) : std::string{};
  if (massless >= 0 && massless < system.tables.counts.n_free_turns) {
    diagnostics.error("E-MODEL-076", "bodies." + name + ".inertia",
                      fmt::format("body '{}': nothing has inertia about the point it turns about, and something acts "
                                  "on its angle; its angular acceleration is not determined",
                                  name),
                      {"give it an inertia above 0"});
  } else {
    diagnostics.error("E-MODEL-073", "", "the accelerations at the start are not determined",
                      {"the start may be singular: change a start angle or a driver's start"});
  }
  throw ModelError(diagnostics);
}

}  // namespace

void require_start(const Mechanism& mechanism, const Assembly& assembly) {
  require_regular(mechanism, assembly);
  require_clear_start(mechanism, assembly);
  require_accelerations(mechanism, assembly);
}

}  // namespace gudgeon
