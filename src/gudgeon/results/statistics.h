// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics of channels taken while they are computed, at every accepted step.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Extremes, mean and rms of some channels over time, between the first and the last update.
///
/// Extremes are those of all values, also of those noted between steps.
/// mean = (1/T) ∫ x dt and rms = √((1/T) ∫ x² dt) by the trapezoidal rule over the accepted steps; sums are
/// compensated, so their error does not grow with the number of steps. A jump is two updates at the same
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

  void transfer(StateArchive& archive) {
    archive(last_, minimum_, maximum_, minimum_time_, maximum_time_, integral_, square_integral_);
    archive(first_time_, last_time_, empty_);
  }

 private:
  // Compensated sums, one a channel.
  struct Sums {
    std::vector<double> values;
    std::vector<double> lost;  // what rounding took away so far
    void reset(std::size_t n);
    void transfer(StateArchive& archive) { archive(values, lost); }
    [[nodiscard]] double total(std::size_t k) const { return values[k] + lost[k]; }
  };
  void add_to_integrals(double half_step, const double* values);

  // One a channel, each an array of its own: most of an update is then done for several channels at once.
  std::vector<std::string> channels_;
  std::vector<double> last_;
  std::vector<double> minimum_;
  std::vector<double> maximum_;
  std::vector<double> minimum_time_;
  std::vector<double> maximum_time_;
  Sums integral_;
  Sums square_integral_;
  double first_time_ = 0.0;  // [s]
  double last_time_ = 0.0;   // [s]
  bool empty_ = true;
};

}  // namespace gudgeon
