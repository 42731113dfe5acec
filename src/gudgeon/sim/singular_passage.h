// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Over a singular position in one stride.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

/// At a singular position (all bars of a loop in line) the closures lose a row: the motion goes through smoothly, but
/// the equations beside it magnify every rounding error, the more the nearer a step ends. So the integrator does not
/// walk up to it. It keeps a short history, and where closeness says that such a position lies ahead, the smooth motion
/// is continued to as far behind it by the Hermite polynomial through values and slopes of four past steps.
class SingularPassage {
 public:
  /// For states of that many components, continued to within `tolerance` of each.
  SingularPassage(std::size_t n_components, double tolerance);

  /// One accepted step; closeness as find_singular_closeness() gives it. Far from any singular position nothing is
  /// kept.
  void note(double time, const std::vector<double>& y, const std::vector<double>& slope, double closeness);
  /// The motion is about to lose its smoothness: a contact changes.
  void forget() {
    n_entries_ = 0;
    last_worst_ = kNothingKnown;
  }

  /// Longest step [s] that still leaves enough of them before a singular position ahead to continue the motion from.
  [[nodiscard]] double find_longest_step() const;

  /// Where the stride would end, when a singular position lies ahead and the history tells the way over it to within
  /// tolerance.
  [[nodiscard]] std::optional<double> find_far_side();

  /// The continued motion at a time between the last noted step and the far side.
  void interpolate(double time, std::vector<double>& y) const;

  void transfer(StateArchive& archive);

 private:
  static constexpr double kNothingKnown = std::numeric_limits<double>::infinity();
  struct Entry {
    double time = 0.0;
    double distance = 0.0;  // 1/√closeness: goes to zero linearly with time
    std::vector<double> y;
    std::vector<double> slope;
    void transfer(StateArchive& archive) { archive(time, distance, y, slope); }
  };
  [[nodiscard]] double find_time_left() const;
  // The step noted `back` steps before the newest.
  [[nodiscard]] const Entry& entry(std::size_t back) const {
    return ring_[(newest_ + ring_.size() - back) % ring_.size()];
  }
  void choose_nodes(double stride);
  [[nodiscard]] double extrapolate(double time, std::size_t component, std::size_t n_nodes) const;

  double tolerance_;
  std::vector<Entry> ring_;
  std::size_t newest_ = 0;
  std::size_t n_entries_ = 0;
  std::vector<const Entry*> nodes_;    // newest first
  double last_worst_ = kNothingKnown;  // largest estimate before the last step, against what is trusted
};

}  // namespace gudgeon
