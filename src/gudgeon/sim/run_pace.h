// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a run will come to an end.
#pragma once

#include <cstdint>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

/// Counts evaluations against the motion's progress, a window at a time: nothing of it depends on the clock. A run goes
/// nowhere when two windows in a row advance so little that a cycle would take kMostEvaluations; the costliest contacts
/// take a ten-thousandth of that.
class RunPace {
 public:
  static constexpr std::int64_t kWindow = 1'000'000;
  static constexpr double kMostEvaluations = 1e11;  ///< a cycle: a day of computing

  explicit RunPace(double cycle_time) : least_advance_(cycle_time * kWindow / kMostEvaluations) {}

  /// After a step: the time that it came to and the evaluations and steps taken so far. False when the run goes
  /// nowhere.
  bool note(double time, std::int64_t evaluations, std::int64_t steps) noexcept {
    if (evaluations - window_evaluations_ < kWindow) return true;
    const double advance = time - window_time_;
    const bool was_slow = is_slow_;
    is_slow_ = advance < least_advance_;
    last_step_ = advance / static_cast<double>(steps > window_steps_ ? steps - window_steps_ : 1);
    last_advance_ = advance;
    window_time_ = time;
    window_evaluations_ = evaluations;
    window_steps_ = steps;
    return !(was_slow && is_slow_);
  }

  void transfer(StateArchive& archive) {
    archive(window_time_, window_evaluations_, window_steps_, is_slow_, last_advance_, last_step_);
  }

  /// By how much the last window came on [s].
  [[nodiscard]] double last_advance() const { return last_advance_; }
  /// The mean step of the last window [s].
  [[nodiscard]] double last_step() const { return last_step_; }

 private:
  double least_advance_;  // [s] of a window
  double window_time_ = 0.0;
  std::int64_t window_evaluations_ = 0;
  std::int64_t window_steps_ = 0;
  bool is_slow_ = false;
  double last_advance_ = 0.0;
  double last_step_ = 0.0;
};

}  // namespace gudgeon
