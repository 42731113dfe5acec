// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Error norm and controller; equations are numbered as in docs/theory/time.md.
#include "gudgeon/sim/step_control.h"

#include <algorithm>
#include <cmath>

namespace gudgeon {

namespace {

// Safety and bounds of one change; exponents of the controller for order 5.
constexpr double kSafety = 0.9;
constexpr double kLeastChange = 0.2;
constexpr double kMostChange = 5.0;
constexpr double kErrorExponent = 0.17;
constexpr double kLastErrorExponent = 0.04;
// Errors below these say no more about the next step.
constexpr double kLeastError = 1e-10;
constexpr double kLeastLogError = -9.0;  // ln of 1.2e-4
// For the energy balance a step keeps at most this share of its tolerance. What it is off by may be rounding, or the
// work of feedback, which no length of a step would mend; unless it may as well be what the losses of contacts are off
// by, which the motion need not feel.
constexpr double kStrictest = 0.1;

}  // namespace

StepControl::StepControl(const ErrorTolerance& tolerance, double first_step)
    : tolerance_(&tolerance), next_(first_step) {}

// Root mean square of the local errors against their tolerances; not finite when anything is not:
// err² = mean of [error_i/(atol + rtol · size_i)]²,  size_i = max(|y_i(t)|, |y_i(t + h)|)      (Eq. T2)
double StepControl::find_error(const AttemptedStep& step) const {
  const std::size_t n_controlled = tolerance_->n_controlled();
  double sum = 0.0;
  for (std::size_t i = 0; i < step.end.size(); ++i) {
    sum += 0.0 * step.end[i];  // an infinite component would make its own tolerance infinite
    if (i >= n_controlled) continue;
    const double size = std::max(std::abs(step.start[i]), std::abs(step.end[i]));
    const double ratio = step.error[i] / tolerance_->find(i, size);
    sum += ratio * ratio;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(n_controlled, 1));
  return std::max(std::sqrt(sum / count), kLeastError);
}

// h_next = h · clamp(0.9 err^−0.17 err_last^0.04, 0.2, 5), after a rejection at most 0.9 h      (Eq. T3)
bool StepControl::accepts(const AttemptedStep& step) {
  const double local_error = find_error(step);
  const double energy_error = std::min(step.energy_error, std::max(local_error / kStrictest, step.loss_error));
  const double error = std::max({local_error, energy_error, step.work_error});
  if (!std::isfinite(error)) {
    next_ = kLeastChange * step.h;
    return false;
  }
  const double log_error = std::log(error);
  const double change = kSafety * std::exp(kLastErrorExponent * log_last_error_ - kErrorExponent * log_error);
  const bool accepted = error <= 1.0;
  // A rejected step must shrink.
  next_ = step.h * std::clamp(change, kLeastChange, accepted ? kMostChange : kSafety);
  if (accepted) log_last_error_ = std::max(log_error, kLeastLogError);
  return accepted;
}

void StepControl::shorten(double h) { next_ = kLeastChange * h; }

void StepControl::note_onset() {
  if (step_after_onset_ > 0.0) next_ = std::min(next_, step_after_onset_);
  after_onset_ = true;
}

void StepControl::note_step(double h) {
  if (!after_onset_) return;
  step_after_onset_ = h;
  after_onset_ = false;
}

}  // namespace gudgeon
