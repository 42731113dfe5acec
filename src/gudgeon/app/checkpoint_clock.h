// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// When a case takes its next checkpoint.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>

namespace gudgeon {

/// Asks for one when an interval has passed since the last, or nine times as long as that took to write: a slow disk
/// costs a tenth of the time at most.
class CheckpointClock {
 public:
  using Seconds = std::chrono::duration<double>;
  static constexpr double kLeastRest = 9.0;

  // From the thread that runs the case.
  void begin(double now, double interval) {
    interval_ = interval;
    wanted_ = false;
    due_ = now + interval;
  }
  void note_written(double began, double now) {
    wanted_ = false;
    due_ = now + std::max(interval_, kLeastRest * (now - began));
  }
  [[nodiscard]] std::atomic<bool>& wanted() { return wanted_; }

  // From another thread.
  void tick(double now) {
    if (now >= due_) wanted_ = true;
  }

  /// [s] of a clock that never goes back.
  [[nodiscard]] static double read() { return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count(); }

 private:
  std::atomic<bool> wanted_ = false;
  std::atomic<double> due_ = std::numeric_limits<double>::infinity();  // [s]
  double interval_ = 0.0;                                              // [s]
};

}  // namespace gudgeon
