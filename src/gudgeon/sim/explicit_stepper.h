// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Steps by the Runge-Kutta pair, their lengths by its error estimate.
#pragma once

#include "gudgeon/sim/step_control.h"
#include "gudgeon/sim/stepper.h"
#include "gudgeon/sim/tsitouras.h"

namespace gudgeon {

/// The last stage of a step is the first of the next.
class ExplicitStepper final : public Stepper {
 public:
  ExplicitStepper(MotionEquations& equations, SolverStatistics& statistics, const ErrorTolerance& tolerance,
                  double first_step);

  void begin(double time, const std::vector<double>& y, const std::vector<double>& slope, bool continues) override;
  bool attempt(double longest, double left) override;
  void end_at(double h) override;
  void shorten() override { control_.shorten(attempted_); }
  void accept() override;
  [[nodiscard]] double next_step() const override { return control_.next_step(); }
  /// h |λ| [1] of the last step, weighted by the tolerances.
  [[nodiscard]] double find_stiffness() const noexcept;
  void note_onset() override { control_.note_onset(); }
  [[nodiscard]] bool evaluates_end() const override { return true; }
  [[nodiscard]] const DenseStep& dense() const override { return formula_; }
  [[nodiscard]] std::span<const double> weights() const override { return Tsitouras::kWeights; }
  [[nodiscard]] std::span<const double> nodes() const override { return Tsitouras::kNodes; }
  [[nodiscard]] std::span<const double> shares() const override { return Tsitouras::kShares; }

 private:
  Tsitouras formula_;
  StepControl control_;
  const ErrorTolerance& tolerance_;
  double attempted_ = 0.0;  // [s]
};

}  // namespace gudgeon
