// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How long the next step may be.
#pragma once

#include <cstddef>
#include <span>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/sim/error_tolerance.h"

namespace gudgeon {

/// A step that was tried: its length [s], the states at its ends, the estimated local error of each, what it adds to
/// the energy balance's residual by what it may add [1], the estimated error of what contacts lose in it by the same
/// [1], and the error of its works by what that may be [1].
struct AttemptedStep {
  double h;
  std::span<const double> start;
  std::span<const double> end;
  std::span<const double> error;
  double energy_error = 0.0;
  double loss_error = 0.0;
  double work_error = 0.0;
};

/// Proportional-integral control of the step by its local error, Hairer & Wanner 1996, IV.2, and by the energy balance.
class StepControl {
 public:
  /// What follows the components that have a tolerance is carried along without one. Holds on to the tolerance.
  StepControl(const ErrorTolerance& tolerance, double first_step);

  /// Length proposed for the next attempt [s].
  [[nodiscard]] double next_step() const { return next_; }

  /// Whether the attempted step keeps the tolerance, or as little as a tenth of it where the energy balance needs that,
  /// or less where the losses of contacts do; proposes the next length either way.
  bool accepts(const AttemptedStep& step);

  /// The step kept the tolerance but could not be used for another reason.
  void shorten(double h);

  /// Takes this length for the next attempt [s].
  void propose(double h) { next_ = h; }

  /// A contact has begun: its time scale is not that of free flight. Proposes the length that worked after the last
  /// onset.
  void note_onset();
  /// The length of an accepted step.
  void note_step(double h);

  void transfer(StateArchive& archive) { archive(next_, log_last_error_, step_after_onset_, after_onset_); }

 private:
  [[nodiscard]] double find_error(const AttemptedStep& step) const;

  const ErrorTolerance* tolerance_;
  double next_;
  double log_last_error_ = 0.0;  // of the last accepted step
  double step_after_onset_ = 0.0;
  bool after_onset_ = false;
};

}  // namespace gudgeon
