// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stages, error, samples.
#include "gudgeon/sim/explicit_stepper.h"

#include <algorithm>
#include <cmath>

namespace gudgeon {

ExplicitStepper::ExplicitStepper(MotionEquations& equations, SolverStatistics& statistics,
                                 const ErrorTolerance& tolerance, double first_step)
    : Stepper(equations, statistics, Tsitouras::kStages),
      formula_(equations.n_states(), kEnergyIntegrals),
      control_(tolerance, first_step),
      tolerance_(tolerance) {}

void ExplicitStepper::begin(double time, const std::vector<double>& y, const std::vector<double>& slope,
                            bool /*continues*/) {
  formula_.begin(time, y, slope);
  pass_samples_on();
}

bool ExplicitStepper::attempt(double longest, double left) {
  double h = std::min(control_.next_step(), longest);
  if (h >= left * (1.0 - 1e-12)) h = left;  // no sliver of a step before a milestone
  attempted_ = h;
  end_at(h);
  return control_.accepts({h, formula_.start(), formula_.end(), formula_.error()});
}

void ExplicitStepper::end_at(double h) {
  formula_.attempt(h, [&](int stage, double t, const double* y, double* slope) {
    equations_.eval(t, y, slope);
    take_samples(stage);
  });
  statistics_.evaluations += Tsitouras::kStages - 1;
}

double ExplicitStepper::find_stiffness() const noexcept {
  return formula_.find_stiffness(tolerance_.n_controlled(), [this](std::size_t i, double value) {
    return 1.0 / tolerance_.find(i, std::abs(value));
  });
}

void ExplicitStepper::accept() {
  control_.note_step(formula_.step());
  end_ = formula_.end();
  std::ranges::copy(formula_.end_slope(), end_slope_.begin());
}

}  // namespace gudgeon
