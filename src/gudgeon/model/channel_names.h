// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What an expression or a table of a load may depend on.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "gudgeon/base/quantity.h"
#include "gudgeon/model/mechanism.h"

namespace gudgeon {

/// Which number of the mechanism's position and speed a name stands for.
struct StateChannel {
  enum class Quantity {
    time,  ///< t [s]
    x,     ///< of a body's centre of mass or of one of its points [m]
    y,
    x_velocity,  ///< [m/s]
    y_velocity,
    angle,         ///< of a body [rad]
    angle_rate,    ///< [rad/s]
    displacement,  ///< along a prismatic joint [m]
    speed,         ///< along a prismatic joint [m/s]
  };
  std::string name;  ///< "t", "piston.x", "rod.B.x_velocity", "crank.angle", "guide.displacement"
  Quantity quantity = Quantity::time;
  int body = -1;   ///< index, for those of a body
  int joint = -1;  ///< index, for those of a prismatic joint (with or without clearance)
  Vec2 local;      ///< [m] the point in the body's own axes
};

/// All of them, time first, in the order of the model. They are what a load may depend on: forces and accelerations are
/// not among them, because they depend on the loads.
std::vector<StateChannel> list_state_channels(const Mechanism& mechanism);

/// All state channels, and each by its name.
class ChannelIndex {
 public:
  explicit ChannelIndex(const Mechanism& mechanism);

  [[nodiscard]] const std::vector<StateChannel>& channels() const { return channels_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The number of the first one of that name, or -1.
  [[nodiscard]] int find(std::string_view name) const;
  /// The numbers of those that are words of a formula's text, each once, in their order.
  [[nodiscard]] std::vector<int> find_in_formula(std::string_view text) const;

 private:
  std::vector<StateChannel> channels_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> numbers_;
};

/// What the values of a channel of that name are; nothing when no channel has such a name.
std::optional<Dimension> find_channel_dimension(std::string_view name);

}  // namespace gudgeon
