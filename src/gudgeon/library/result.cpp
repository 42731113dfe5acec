// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Look-ups by name, with an answer that helps when there is no such name.
#include "gudgeon/library/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {
namespace {

template <class Item, class Name>
std::vector<std::string> list_names(const std::vector<Item>& items, Name name) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.*name);
  return names;
}

/// The item of that name; std::out_of_range with the names there are.
template <class Item, class Name>
const Item& find_named(const std::vector<Item>& items, Name member, std::string_view name, std::string_view kind,
                       const std::string& place) {
  const auto found = std::ranges::find(items, name, member);
  if (found != items.end()) return *found;
  const std::vector<std::string> names = list_names(items, member);
  const std::string suggestion = suggest(name, names);
  throw std::out_of_range(fmt::format("there is no {} '{}'{}; there {}{}{}", kind, name, place,
                                      names.empty() ? "is none" : "are: ", join_names(names),
                                      suggestion.empty() ? "" : ". " + suggestion));
}

std::string name_place(const StageRecord& stage) { return fmt::format(" in stage '{}'", stage.name); }

}  // namespace

double DepthProfile::max() const { return depths_.empty() ? 0.0 : std::ranges::max(depths_); }

double DepthProfile::mean() const {
  return depths_.empty() ? 0.0 : std::accumulate(depths_.begin(), depths_.end(), 0.0) / static_cast<double>(size());
}

std::vector<std::string> StageResult::joint_names() const { return list_names(stage_->wear, &JointWear::joint); }

JointResult StageResult::joint(std::string_view name) const {
  return JointResult(find_named(stage_->wear, &JointWear::joint, name, "joint with clearance", name_place(*stage_)));
}

std::vector<std::string> StageResult::channel_names() const { return list_names(stage_->channels, &Channel::name); }

const Channel& StageResult::channel(std::string_view name) const {
  return find_named(stage_->channels, &Channel::name, name, "channel", name_place(*stage_));
}

std::span<const double> StageResult::values(std::string_view channel) const {
  return stage_->values[&this->channel(channel) - stage_->channels.data()];
}

const ChannelStatistics& StageResult::statistics(std::string_view channel) const {
  return find_named(stage_->statistics, &ChannelStatistics::channel, channel, "channel with statistics",
                    name_place(*stage_));
}

double StageResult::energy_error() const { return check_energy(stage_->energy).relative; }

std::vector<std::string> Result::stage_names() const { return list_names(stages_, &StageRecord::name); }

StageResult Result::stage(std::string_view name) const& {
  return StageResult(find_named(stages_, &StageRecord::name, name, "stage", ""));
}

std::vector<std::string> Result::problems() const {
  std::vector<std::string> problems;
  for (const StageRecord& stage : stages_) {
    if (is_unbalanced(stage)) problems.push_back(fmt::format("stage {}: {}", stage.name, explain_imbalance(stage)));
    if (stage.status != StageStatus::finished) {
      problems.push_back(fmt::format("stage {}: {}", stage.name, stage.message));
    }
  }
  return problems;
}

}  // namespace gudgeon
