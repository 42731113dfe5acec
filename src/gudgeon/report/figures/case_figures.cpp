// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which channels the figures need, and the figures topic after topic.
#include "gudgeon/report/figures/case_figures.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string_view>

#include "gudgeon/analysis/slider_coordinates.h"

namespace gudgeon {

namespace {

template <class Item, class Key>
void add_once(std::vector<Item>& items, const Item& item, Key key) {
  if (std::ranges::find(items, std::invoke(key, item), key) == items.end()) items.push_back(item);
}

bool is_recorded(const StageRecord& stage, const std::string& channel) {
  return std::ranges::find(stage.channels, channel, &Channel::name) != stage.channels.end();
}

std::vector<std::string> find_slider_motions(const RunRecord& run) {
  std::vector<std::string> channels;
  for (const StageRecord& stage : run.stages) {
    for (const std::string& coordinate : find_slider_coordinates(stage)) {
      for (const char* ending : {"", "_velocity", "_acceleration"}) {
        add_once(channels, coordinate + ending, std::identity{});
      }
    }
  }
  return channels;
}

}  // namespace

std::vector<std::string> find_clearance_joints(const RunRecord& run) {
  std::vector<std::string> joints;
  for (const StageRecord& stage : run.stages) {
    for (const JointWear& wear : stage.wear) add_once(joints, wear.joint, std::identity{});
  }
  return joints;
}

const JointWear* find_wear(const StageRecord& stage, const std::string& joint) {
  const auto found = std::ranges::find(stage.wear, joint, &JointWear::joint);
  return found == stage.wear.end() ? nullptr : &*found;
}

std::vector<std::string> find_motion_channels(const RunRecord& run) {
  std::vector<std::string> channels = find_slider_motions(run);
  if (!channels.empty() || run.stages.empty()) return channels;
  constexpr std::string_view kTurning = ".angle_acceleration";
  for (const Channel& channel : run.stages.front().channels) {
    if (!channel.name.ends_with(kTurning)) continue;
    const std::string body = channel.name.substr(0, channel.name.size() - kTurning.size());
    channels = {body + ".angle", body + ".angle_rate", channel.name};
  }
  return channels;
}

std::vector<Channel> find_effort_channels(const RunRecord& run) {
  std::vector<Channel> efforts;
  for (const StageRecord& stage : run.stages) {
    for (const Channel& channel : stage.channels) {
      if (channel.name.ends_with(".effort")) add_once(efforts, channel, &Channel::name);
    }
  }
  return efforts;
}

std::vector<std::string> find_figure_channels(const RunRecord& outline, const StageRecord& stage) {
  std::vector<std::string> wanted = find_motion_channels(outline);
  for (const Channel& effort : find_effort_channels(outline)) wanted.push_back(effort.name);
  for (const std::string& joint : find_clearance_joints(outline)) {
    for (const char* ending :
         {".normal_force", ".x_offset", ".y_offset", ".x_offset_rate", ".y_offset_rate",   // a bearing's
          ".displacement", ".speed", ".height", ".height_rate", ".tilt", ".tilt_rate"}) {  // a slot's
      wanted.push_back(joint + ending);
    }
  }
  std::erase_if(wanted, [&](const std::string& channel) { return !is_recorded(stage, channel); });
  return wanted;
}

std::vector<Figure> make_case_figures(Signals& signals) {
  std::vector<Figure> figures = make_wear_figures(signals.run());
  for (const auto make : {make_motion_figures, make_drive_figures, make_contact_figures, make_journal_figures}) {
    std::ranges::move(make(signals), std::back_inserter(figures));
  }
  return figures;
}

}  // namespace gudgeon
