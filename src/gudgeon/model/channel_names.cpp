// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The names of positions and speeds; those of bodies are the recorded channels'.
#include "gudgeon/model/channel_names.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "gudgeon/base/formula_tokens.h"

namespace gudgeon {

namespace {

using enum StateChannel::Quantity;

void add_position(std::vector<StateChannel>& channels, const std::string& owner, int body, Vec2 local) {
  channels.push_back({owner + ".x", x, body, -1, local});
  channels.push_back({owner + ".y", y, body, -1, local});
}

void add_velocity(std::vector<StateChannel>& channels, const std::string& owner, int body, Vec2 local) {
  channels.push_back({owner + ".x_velocity", x_velocity, body, -1, local});
  channels.push_back({owner + ".y_velocity", y_velocity, body, -1, local});
}

void add_body(std::vector<StateChannel>& channels, const Body& body, int index) {
  if (index > 0) {
    add_position(channels, body.name, index, body.center_of_mass);
    channels.push_back({body.name + ".angle", angle, index, -1, {}});
    add_velocity(channels, body.name, index, body.center_of_mass);
    channels.push_back({body.name + ".angle_rate", angle_rate, index, -1, {}});
  }
  for (const Point& point : body.points) {
    const std::string owner = body.name + "." + point.name;
    add_position(channels, owner, index, point.position);
    add_velocity(channels, owner, index, point.position);
  }
}

}  // namespace

std::vector<StateChannel> list_state_channels(const Mechanism& mechanism) {
  std::vector<StateChannel> channels{{"t", time, -1, -1, {}}};
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    add_body(channels, mechanism.bodies[b], static_cast<int>(b));
  }
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Joint& joint = mechanism.joints[j];
    if (!std::holds_alternative<Prismatic>(joint.kind) && !std::holds_alternative<PrismaticClearance>(joint.kind)) {
      continue;
    }
    channels.push_back({joint.name + ".displacement", displacement, -1, static_cast<int>(j), {}});
    channels.push_back({joint.name + ".speed", speed, -1, static_cast<int>(j), {}});
  }
  return channels;
}

ChannelIndex::ChannelIndex(const Mechanism& mechanism) : channels_(list_state_channels(mechanism)) {
  for (const StateChannel& channel : channels_) {
    numbers_.emplace(channel.name, static_cast<int>(names_.size()));
    names_.push_back(channel.name);
  }
}

int ChannelIndex::find(std::string_view name) const {
  const auto found = numbers_.find(std::string{name});
  return found == numbers_.end() ? -1 : found->second;
}

std::vector<int> ChannelIndex::find_in_formula(std::string_view text) const {
  std::set<int> found;
  for (const FormulaToken& token : split_formula(text)) {
    if (token.kind != FormulaToken::Kind::name) continue;
    if (const int number = find(token.text); number >= 0) found.insert(number);
  }
  return {found.begin(), found.end()};
}

std::optional<Dimension> find_channel_dimension(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, Dimension>, 8> kBySuffix{{
      {".x", dimension::kLength},
      {".y", dimension::kLength},
      {".displacement", dimension::kLength},
      {".x_velocity", dimension::kSpeed},
      {".y_velocity", dimension::kSpeed},
      {".speed", dimension::kSpeed},
      {".angle", dimension::kAngle},
      {".angle_rate", dimension::kAngularSpeed},
  }};
  if (name == "t") return dimension::kTime;
  const auto* found = std::ranges::find_if(kBySuffix, [&](const auto& item) { return name.ends_with(item.first); });
  return found == kBySuffix.end() ? std::nullopt : std::optional{found->second};
}

}  // namespace gudgeon
