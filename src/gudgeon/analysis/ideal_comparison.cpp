// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Differences of recorded channels, sample by sample.
#include "gudgeon/analysis/ideal_comparison.h"

#include <fmt/format.h>

#include <cmath>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

const std::vector<double>& find_recorded(const StageRecord& stage, std::string_view channel) {
  const std::vector<double>* values = find_values(stage, channel);
  if (values == nullptr) {
    throw NumericalError(fmt::format("stage '{}' has no channel '{}'", stage.name, channel));
  }
  if (values->empty() || values->size() != stage.time.size()) {
    throw NumericalError(fmt::format("stage '{}': channel '{}' has {} values at {} times; read its values first",
                                     stage.name, channel, values->size(), stage.time.size()));
  }
  return *values;
}

void check_same_times(const StageRecord& stage, const StageRecord& ideal) {
  const double tolerance = kSameTimeFraction * stage.cycle_time;
  bool same = stage.time.size() <= ideal.time.size();
  for (std::size_t i = 0; same && i < stage.time.size(); ++i) {
    same = std::abs(stage.time[i] - ideal.time[i]) <= tolerance;
  }
  if (!same) {
    throw NumericalError(
        fmt::format("stages '{}' and '{}' are not recorded at the same times; run both with the same "
                    "cycles and outputs_per_cycle",
                    stage.name, ideal.name));
  }
}

}  // namespace

std::vector<double> find_error_series(const StageRecord& stage, const StageRecord& ideal, std::string_view channel) {
  const std::vector<double>& ours = find_recorded(stage, channel);
  const std::vector<double>& theirs = find_recorded(ideal, channel);
  check_same_times(stage, ideal);
  std::vector<double> error(ours.size());
  for (std::size_t i = 0; i < error.size(); ++i) error[i] = ours[i] - theirs[i];
  return error;
}

IdealError find_ideal_error(const StageRecord& stage, const StageRecord& ideal, std::string_view channel) {
  const std::vector<double> error = find_error_series(stage, ideal, channel);
  IdealError result{error.front(), stage.time.front(), 0.0};
  double square_integral = 0.0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    if (std::abs(error[i]) > std::abs(result.largest)) result.largest = error[i], result.largest_time = stage.time[i];
    if (i == 0) continue;
    const double half_step = 0.5 * (stage.time[i] - stage.time[i - 1]);
    square_integral += half_step * (error[i] * error[i] + error[i - 1] * error[i - 1]);
  }
  const double duration = stage.time.back() - stage.time.front();
  result.rms = duration > 0.0 ? std::sqrt(square_integral / duration) : std::abs(error.front());
  return result;
}

}  // namespace gudgeon
