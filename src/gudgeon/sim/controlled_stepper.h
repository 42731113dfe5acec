// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Steppers that start from the state alone: each step by a Runge-Kutta pair, its length by the pair's error estimate.
#pragma once

#include <algorithm>

#include "gudgeon/sim/ledger_control.h"
#include "gudgeon/sim/step_control.h"
#include "gudgeon/sim/stepper.h"

namespace gudgeon {

/// What is left to a formula is to take a step and to tell of it.
class ControlledStepper : public Stepper {
 public:
  ControlledStepper(MotionEquations& equations, SolverStatistics& statistics, const ErrorTolerance& tolerance,
                    int n_stages, double first_step)
      : Stepper(equations, statistics, n_stages), control_(tolerance, first_step) {}

  bool attempt(double longest, double left) final {
    double h = std::min(control_.next_step(), longest);
    if (h >= left * (1.0 - 1e-12)) h = left;  // no sliver of a step before a milestone
    attempted_ = h;
    end_at(h);
    AttemptedStep step = describe_attempt();
    end_residual_ = equations_.find_residual(step.end.data());
    step.ledger_error = ledger_.find_error(end_residual_, find_exchanged(step.end));
    return control_.accepts(step);
  }
  void shorten() final { control_.shorten(attempted_); }
  [[nodiscard]] double next_step() const final { return control_.next_step(); }
  void note_onset() final { control_.note_onset(); }
  /// Starts with a step of that length [s], whatever was proposed.
  void propose(double h) { control_.propose(h); }
  [[nodiscard]] bool evaluates_end() const final { return true; }

 protected:
  /// The last attempt; an error that is not finite where it failed.
  [[nodiscard]] virtual AttemptedStep describe_attempt() const = 0;
  /// The workspace was evaluated at the start of the next step.
  void begin_ledger(const std::vector<double>& y, bool continues) noexcept {
    const bool is_known = continues && was_whole_ && y == end_;
    ledger_.begin(is_known ? end_residual_ : equations_.find_residual(y.data()), find_exchanged(y));
  }
  // A step that was ended early, where a contact changes, says nothing of how long others may be.
  void note_accepted(double h) {
    was_whole_ = h == attempted_;
    if (was_whole_) control_.note_step(h);
  }

 private:
  [[nodiscard]] double find_exchanged(std::span<const double> y) const noexcept {
    return y[equations_.n_states() + kExchanged];
  }

  StepControl control_;
  LedgerControl ledger_;
  double attempted_ = 0.0;     // [s]
  double end_residual_ = 0.0;  // [J] of the ledger at the end of the attempt
  bool was_whole_ = false;     // the last step was as long as it was attempted
};

}  // namespace gudgeon
