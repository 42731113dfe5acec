// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics of channels taken while they are computed, at every accepted step.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Extremes, mean and rms of some channels over time, between the first and the last update.
///
/// Extremes are those of all values, also of those noted between steps.
/// mean = (1/T) ∫ x dt and rms = √((1/T) ∫ x² dt) by the trapezoidal rule over the accepted steps; sums are
/// compensated (Neumaier), so their error does not grow with the number of steps. A jump is two updates at the same
/// time, which weigh nothing. A NaN passes into mean and rms and is left out of the extremes; no update at all gives
/// NaN everywhere. Same updates, same bits.
class StatisticsAccumulator {
 public:
  explicit StatisticsAccumulator(std::vector<std::string> channels);

  /// Forgets everything: the start of the counted cycles.
  void reset();
  /// One accepted step: times must not decrease; values holds one a channel, in their order. Allocates nothing.
  void update(double time, std::span<const double> values);
  /// Values between two steps, which only count for the extremes. Allocates nothing.
  void note_extremes(double time, std::span<const double> values);
  /// In the order of the channels.
  [[nodiscard]] std::vector<ChannelStatistics> summarize() const;

 private:
  struct Sum {
    double value = 0.0;
    double lost = 0.0;  // what rounding took away so far
    void add(double term);
    [[nodiscard]] double total() const { return value + lost; }
  };
  struct Running {
    void note_extremes(double time, double x, bool is_first);
    double last = 0.0;
    double minimum = 0.0;
    double minimum_time = 0.0;
    double maximum = 0.0;
    double maximum_time = 0.0;
    Sum integral;
    Sum square_integral;
  };

  std::vector<std::string> channels_;
  std::vector<Running> running_;  // one a channel
  double first_time_ = 0.0;       // [s]
  double last_time_ = 0.0;        // [s]
  bool empty_ = true;
};

}  // namespace gudgeon
