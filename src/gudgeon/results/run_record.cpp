// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Look-ups in a run record.
#include "gudgeon/results/run_record.h"

#include <algorithm>
#include <functional>

namespace gudgeon {

namespace {

std::vector<double> add_depths(std::vector<double> depths, const std::vector<double>& added) {
  std::ranges::transform(depths, added, depths.begin(), std::plus{});
  return depths;
}

}  // namespace

std::vector<double> JointWear::bearing_depth_after() const { return add_depths(bearing_depth, bearing_depth_added); }

std::vector<double> JointWear::journal_depth_after() const { return add_depths(journal_depth, journal_depth_added); }

const std::vector<double>* find_values(const StageRecord& stage, std::string_view channel) {
  const auto found = std::ranges::find(stage.channels, channel, &Channel::name);
  if (found == stage.channels.end()) return nullptr;
  return &stage.values[found - stage.channels.begin()];
}

const ChannelStatistics* find_statistics(const StageRecord& stage, std::string_view channel) {
  const auto found = std::ranges::find(stage.statistics, channel, &ChannelStatistics::channel);
  return found == stage.statistics.end() ? nullptr : &*found;
}

const StageRecord* find_stage(const RunRecord& run, std::string_view name) {
  const auto found = std::ranges::find(run.stages, name, &StageRecord::name);
  return found == run.stages.end() ? nullptr : &*found;
}

}  // namespace gudgeon
