// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Running sums of channels over time.
#include "gudgeon/results/statistics.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace gudgeon {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void StatisticsAccumulator::Sum::add(double term) {
  const double next = value + term;
  lost += std::abs(value) >= std::abs(term) ? (value - next) + term : (term - next) + value;
  value = next;
}

StatisticsAccumulator::StatisticsAccumulator(std::vector<std::string> channels)
    : channels_(std::move(channels)), running_(channels_.size()) {}

void StatisticsAccumulator::reset() {
  for (Running& r : running_) r = Running{};
  empty_ = true;
}

// Written so that the first value, and one after NaN, are taken.
void StatisticsAccumulator::Running::note_extremes(double time, double x, bool is_first) {
  if (is_first || x < minimum || std::isnan(minimum)) minimum = x, minimum_time = time;
  if (is_first || x > maximum || std::isnan(maximum)) maximum = x, maximum_time = time;
}

void StatisticsAccumulator::note_extremes(double time, std::span<const double> values) {
  assert(!empty_ && values.size() == running_.size());
  for (std::size_t k = 0; k < running_.size(); ++k) running_[k].note_extremes(time, values[k], false);
}

void StatisticsAccumulator::update(double time, std::span<const double> values) {
  assert(values.size() == running_.size());
  assert(empty_ || time >= last_time_);
  if (empty_) first_time_ = time;
  const double half_step = empty_ ? 0.0 : 0.5 * (time - last_time_);
  for (std::size_t k = 0; k < running_.size(); ++k) {
    Running& r = running_[k];
    const double x = values[k];
    r.note_extremes(time, x, empty_);
    if (half_step > 0.0) {
      r.integral.add(half_step * (r.last + x));
      r.square_integral.add(half_step * (r.last * r.last + x * x));
    }
    r.last = x;
  }
  last_time_ = time;
  empty_ = false;
}

std::vector<ChannelStatistics> StatisticsAccumulator::summarize() const {
  std::vector<ChannelStatistics> statistics;
  const double duration = last_time_ - first_time_;
  for (std::size_t k = 0; k < running_.size(); ++k) {
    const Running& r = running_[k];
    ChannelStatistics& s = statistics.emplace_back(
        ChannelStatistics{channels_[k], kNothing, kNothing, kNothing, kNothing, kNothing, kNothing});
    if (empty_) continue;
    s.minimum = r.minimum;
    s.minimum_time = r.minimum_time;
    s.maximum = r.maximum;
    s.maximum_time = r.maximum_time;
    // a single moment has its own value as mean
    s.mean = duration > 0.0 ? r.integral.total() / duration : r.last;
    s.rms = duration > 0.0 ? std::sqrt(r.square_integral.total() / duration) : std::abs(r.last);
  }
  return statistics;
}

}  // namespace gudgeon
