// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One step, and the changes of contact in it.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "gudgeon/sim/contact_events.h"
#include "gudgeon/sim/motion_equations.h"
#include "gudgeon/sim/tsitouras.h"

namespace gudgeon {

/// A step that counts how often its dense output is asked for.
class CountedStep final : public DenseStep {
 public:
  explicit CountedStep(const DenseStep& step) : DenseStep(step), step_(step) {}
  void interpolate(double share, std::size_t n_wanted, double* y) const noexcept override {
    ++n_looks;
    step_.interpolate(share, n_wanted, y);
  }

  mutable int n_looks = 0;

 private:
  const DenseStep& step_;
};

/// One attempted step of a mechanism from its start, and what the events make of it.
class Attempt {
 public:
  explicit Attempt(const Mechanism& mechanism)
      : assembly(assemble(mechanism)), system(compile(mechanism, assembly)), equations(system, {}) {}

  Attempt(const Attempt&) = delete;  // the equations hold on to the system
  Attempt& operator=(const Attempt&) = delete;

  std::optional<ContactChange> find_change(double h) {
    ContactEvents events(system.tables);
    Tsitouras stepper(equations.n_states(), kEnergyIntegrals);
    const State state = make_state(system, assembly);
    std::vector<double> y(equations.size(), 0.0);
    std::vector<double> slope(equations.size());
    std::ranges::copy(state.q, y.begin());
    std::ranges::copy(state.v, y.begin() + static_cast<std::ptrdiff_t>(equations.n_free()));
    start.resize(system.tables.contacts.size());
    end.resize(start.size());
    equations.eval(0.0, y.data(), slope.data());
    events.find_gaps(equations.workspace, start);
    stepper.begin(0.0, y, slope);
    stepper.attempt(h, [&](int, double t, const double* at, double* dydt) { equations.eval(t, at, dydt); });
    events.find_gaps(equations.workspace, end);
    Workspace scratch(system.tables);
    const CountedStep step(stepper);
    const auto change = events.find_first_change(step, equations.contact_modes, start, end, scratch);
    n_looks = step.n_looks;
    return change;
  }

  Assembly assembly;
  System system;
  MotionEquations equations;
  std::vector<GapState> start;
  std::vector<GapState> end;
  int n_looks = 0;  // into the step
};

}  // namespace gudgeon
