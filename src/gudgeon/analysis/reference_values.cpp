// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Looks up our value for each reference value.
#include "gudgeon/analysis/reference_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gudgeon/analysis/wear_summary.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

double find_peak(const RunRecord& run, std::size_t n_updates, const std::string& channel) {
  const StageRecord* stage = find_stage(run, name_worn_stage(n_updates));
  const ChannelStatistics* statistics = stage == nullptr ? nullptr : find_statistics(*stage, channel);
  return statistics == nullptr ? kNothing : statistics->peak();
}

// Of the surfaces after so many wear updates: what the stage before has added included. Unworn ones have none.
double find_wear_depth(const RunRecord& run, std::size_t n_updates, const std::string& joint) {
  const StageRecord* before = n_updates > 0 ? find_stage(run, name_worn_stage(n_updates - 1)) : nullptr;
  if (before == nullptr) return kNothing;
  const auto wear = std::ranges::find(before->wear, joint, &JointWear::joint);
  if (wear == before->wear.end() || wear->total_depth_added.empty()) return kNothing;
  const auto index = static_cast<std::size_t>(before - run.stages.data());
  return find_deepest(find_accumulated_depth(run, index, joint)).depth;
}

std::string find_unit(const RunRecord& run, const ReferenceRow& row) {
  if (!row.unit.empty()) return row.unit;
  if (row.measure == "wear_depth") return "m";
  for (const StageRecord& stage : run.stages) {
    const auto channel = std::ranges::find(stage.channels, row.channel, &Channel::name);
    if (channel != stage.channels.end()) return channel->unit;
  }
  return "";
}

}  // namespace

std::string name_worn_stage(std::size_t n_updates) {
  return n_updates == 0 ? "no_wear" : fmt::format("wear_{}", n_updates);
}

ReferenceComparison compare_with_reference(const RunRecord& run, const ReferenceRow& row) {
  const bool depth = row.measure == "wear_depth";
  if (!depth && row.measure != "peak") {
    throw NumericalError(fmt::format("reference value '{}': measure '{}' is not known; use peak or wear_depth",
                                     row.quantity, row.measure));
  }
  ReferenceComparison comparison{row, {}, {}, {}};
  comparison.reference.unit = find_unit(run, row);
  for (std::size_t k = 0; k < row.values.size(); ++k) {
    const double ours = depth ? find_wear_depth(run, k, row.channel) : find_peak(run, k, row.channel);
    const double theirs = row.values[k];
    comparison.ours.push_back(ours);
    comparison.ratio.push_back(theirs == 0.0 ? kNothing : std::abs(ours) / std::abs(theirs));
    comparison.stages.push_back(name_worn_stage(k));
  }
  return comparison;
}

}  // namespace gudgeon
