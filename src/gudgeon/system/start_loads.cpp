// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One evaluation of every formula. Constants and curves that passed the check of the model are finite everywhere.
#include "gudgeon/system/start_loads.h"

#include <fmt/format.h>

#include <cmath>

#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/load_forces.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

namespace {

class StartLoads {
 public:
  StartLoads(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics)
      : system_(compile(mechanism, assembly)), workspace_(system_.tables), diagnostics_(diagnostics) {
    const State start = make_state(system_, assembly);
    update_coordinates(system_.tables, 0.0, start.q.data(), start.v.data(), workspace_.coordinates);
    update_point_motions(system_.tables, workspace_);
    add_variable_loads(system_.tables, 0.0, workspace_);
  }

  void check() {
    for (const ForceLoad& force : system_.tables.loads.forces) {
      check(force.load, force.x, "force.0", "x of force");
      check(force.load, force.y, "force.1", "y of force");
    }
    for (const TorqueLoad& torque : system_.tables.loads.torques) check(torque.load, torque.torque, "torque", "torque");
  }

 private:
  void check(int load, const LoadFunction& function, const char* key, const char* what) {
    if (function.expression < 0) return;
    LoadScratch& scratch = workspace_.loads;
    const double value = scratch.evaluators[function.expression].eval(scratch.channel_values.data());
    if (std::isfinite(value)) return;
    const std::string& name = system_.mechanism.loads[load].name;
    diagnostics_.error("E-MODEL-089", fmt::format("loads.{}.{}", name, key),
                       fmt::format("load '{}': {} \"{}\" has no finite value at the start", name, what,
                                   system_.tables.loads.expressions[function.expression].text),
                       {"look at where it is defined: a division by zero, a root or a logarithm of what is negative"});
  }

  System system_;
  Workspace workspace_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_start_loads(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics) {
  StartLoads(mechanism, assembly, diagnostics).check();
}

}  // namespace gudgeon
