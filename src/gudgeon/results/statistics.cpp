// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Running sums of channels over time, by Knuth's two-sum.
#include "gudgeon/results/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace gudgeon {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// Knuth's sum of two numbers and its error, without a branch.
void add_compensated(double term, double& value, double& lost) {
  const double next = value + term;
  const double taken = next - value;
  lost += (value - (next - taken)) + (term - taken);
  value = next;
}

}  // namespace

void StatisticsAccumulator::Sums::reset(std::size_t n) {
  values.assign(n, 0.0);
  lost.assign(n, 0.0);
}

StatisticsAccumulator::StatisticsAccumulator(std::vector<std::string> channels) : channels_(std::move(channels)) {
  reset();
}

void StatisticsAccumulator::reset() {
  const std::size_t n = channels_.size();
  for (auto* numbers : {&last_, &minimum_time_, &maximum_time_}) numbers->assign(n, 0.0);
  for (auto* numbers : {&minimum_, &maximum_}) numbers->assign(n, kNothing);
  integral_.reset(n);
  square_integral_.reset(n);
  empty_ = true;
}

// Written so that the first value, and one after NaN, are taken.
void StatisticsAccumulator::note_extremes(double time, std::span<const double> values) {
  assert(values.size() == last_.size());
  const double* x = values.data();
  const double* minimum = minimum_.data();
  const double* maximum = maximum_.data();
  std::int64_t any = 0;  // not a bool, and no branch: several channels at once
  for (std::size_t k = 0; k < last_.size(); ++k) {
    any |= static_cast<std::int64_t>(!(x[k] >= minimum[k])) | static_cast<std::int64_t>(!(x[k] <= maximum[k]));
  }
  if (any == 0) return;
  for (std::size_t k = 0; k < last_.size(); ++k) {
    if (x[k] < minimum_[k] || std::isnan(minimum_[k])) minimum_[k] = x[k], minimum_time_[k] = time;
    if (x[k] > maximum_[k] || std::isnan(maximum_[k])) maximum_[k] = x[k], maximum_time_[k] = time;
  }
}

void StatisticsAccumulator::add_to_integrals(double half_step, const double* values) {
  double* last = last_.data();
  double* sums = integral_.values.data();
  double* lost = integral_.lost.data();
  double* square_sums = square_integral_.values.data();
  double* square_lost = square_integral_.lost.data();
  const std::size_t n = last_.size();
  for (std::size_t k = 0; k < n; ++k) {
    add_compensated(half_step * (last[k] + values[k]), sums[k], lost[k]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    add_compensated(half_step * (last[k] * last[k] + values[k] * values[k]), square_sums[k], square_lost[k]);
  }
}

void StatisticsAccumulator::update(double time, std::span<const double> values) {
  assert(values.size() == last_.size());
  assert(empty_ || time >= last_time_);
  if (empty_) first_time_ = time;
  const double half_step = empty_ ? 0.0 : 0.5 * (time - last_time_);
  note_extremes(time, values);
  if (half_step > 0.0) add_to_integrals(half_step, values.data());
  std::ranges::copy(values, last_.begin());
  last_time_ = time;
  empty_ = false;
}

std::vector<ChannelStatistics> StatisticsAccumulator::summarize() const {
  std::vector<ChannelStatistics> statistics;
  const double duration = last_time_ - first_time_;
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    ChannelStatistics& s = statistics.emplace_back(
        ChannelStatistics{channels_[k], kNothing, kNothing, kNothing, kNothing, kNothing, kNothing});
    if (empty_) continue;
    s.minimum = minimum_[k];
    s.minimum_time = minimum_time_[k];
    s.maximum = maximum_[k];
    s.maximum_time = maximum_time_[k];
    // a single moment has its own value as mean
    s.mean = duration > 0.0 ? integral_.total(k) / duration : last_[k];
    s.rms = duration > 0.0 ? std::sqrt(square_integral_.total(k) / duration) : std::abs(last_[k]);
  }
  return statistics;
}

}  // namespace gudgeon
