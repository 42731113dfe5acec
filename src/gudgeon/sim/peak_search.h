// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Extremes of many signals that lie between the times at which they are known.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

/// Where a signal turns at one of its points, the parabola through it and its neighbours tells how far it may go
/// between them. Where that would be a new extreme, all signals are measured there, and again until no more is to be
/// gained than a share of 2e-5. A signal that does not turn costs a comparison a point. Allocates nothing after
/// construction.
class PeakSearch {
 public:
  /// Puts all signals at a time between the last three points into the row.
  using Measure = std::function<void(double time, std::span<double> row)>;

  PeakSearch(std::size_t n_signals, Measure measure);

  /// Starts again: what comes before cannot be measured any more. Extremes stay.
  void interrupt() { n_taken_ = 0; }
  /// Extremes of this signal count from the last point on.
  void forget(std::size_t signal);
  /// The row of the next point, to be filled before it is taken.
  [[nodiscard]] std::span<double> next_row() { return row_of(newest_); }
  /// Takes the next row, later than the last, and looks between the three newest points.
  void take(double time);
  /// Looks at a time between the two newest points, and around it for the greatest value of one signal.
  void look_between(double time, std::size_t signal);

  void transfer(StateArchive& archive) {
    archive(rows_, greatest_, least_, points_, n_points_, taken_, n_taken_, newest_);
  }

 private:
  struct Point {
    double time = 0.0;
    std::size_t row = 0;
  };
  static constexpr std::size_t kTaken = 3;
  static constexpr std::size_t kMostPoints = 16;
  static constexpr std::size_t kRows = kMostPoints + 1;  // the next point's may be one beside them

  [[nodiscard]] std::span<double> row_of(std::size_t row) { return {rows_.data() + row * n_signals_, n_signals_}; }
  [[nodiscard]] double value(std::size_t point, std::size_t signal) const {
    return rows_[points_[point].row * n_signals_ + signal];
  }
  void note_extremes(std::span<const double> row) noexcept;
  void search();
  void refine(std::size_t signal, double sign);
  void look(double time, std::size_t place);

  std::size_t n_signals_;
  Measure measure_;
  std::vector<double> rows_;  // of three points that were taken, then of those looked at
  std::vector<double> greatest_;
  std::vector<double> least_;
  std::array<Point, kMostPoints> points_;  // in the order of time
  std::size_t n_points_ = 0;
  std::array<Point, kTaken - 1> taken_;  // the older first
  std::size_t n_taken_ = 0;
  std::size_t newest_ = 2;  // row of the next point
};

}  // namespace gudgeon
