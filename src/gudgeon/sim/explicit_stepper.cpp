// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stages, stiffness, samples.
#include "gudgeon/sim/explicit_stepper.h"

#include <algorithm>
#include <cmath>

namespace gudgeon {

ExplicitStepper::ExplicitStepper(MotionEquations& equations, SolverStatistics& statistics,
                                 const ErrorTolerance& tolerance, double first_step)
    : ControlledStepper(equations, statistics, tolerance, Tsitouras::kStages, first_step),
      formula_(equations.n_states(), kEnergyIntegrals),
      tolerance_(tolerance) {}

void ExplicitStepper::begin(double time, const std::vector<double>& y, const std::vector<double>& slope,
                            bool continues) {
  formula_.begin(time, y, slope);
  begin_energy_control(y, continues);
  pass_samples_on();
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
  note_accepted(formula_.step());
  end_ = formula_.end();
  std::ranges::copy(formula_.end_slope(), end_slope_.begin());
}

}  // namespace gudgeon
