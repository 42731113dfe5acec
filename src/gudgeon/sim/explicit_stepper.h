// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Steps by the explicit Runge-Kutta pair.
#pragma once

#include "gudgeon/sim/controlled_stepper.h"
#include "gudgeon/sim/tsitouras.h"

namespace gudgeon {

/// The last stage of a step is the first of the next.
class ExplicitStepper final : public ControlledStepper {
 public:
  ExplicitStepper(MotionEquations& equations, SolverStatistics& statistics, const ErrorTolerance& tolerance,
                  double first_step);

  void begin(double time, const std::vector<double>& y, const std::vector<double>& slope, bool continues) override;
  void end_at(double h) override;
  void accept() override;
  void transfer(StateArchive& archive) override {
    ControlledStepper::transfer(archive);
    archive(formula_);
  }
  /// h |λ| [1] of the last step, weighted by the tolerances.
  [[nodiscard]] double find_stiffness() const noexcept;
  [[nodiscard]] const DenseStep& dense() const override { return formula_; }
  [[nodiscard]] std::span<const double> weights() const override { return Tsitouras::kWeights; }
  [[nodiscard]] std::span<const double> nodes() const override { return Tsitouras::kNodes; }
  [[nodiscard]] std::span<const double> shares() const override { return Tsitouras::kShares; }

 private:
  [[nodiscard]] AttemptedStep describe_attempt() const override {
    return {formula_.step(), formula_.start(), formula_.end(), formula_.error()};
  }
  [[nodiscard]] double find_error(std::size_t component) const override { return formula_.find_error(component); }

  Tsitouras formula_;
  const ErrorTolerance& tolerance_;
};

}  // namespace gudgeon
