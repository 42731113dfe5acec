// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Channel statistics count first, recorded values where there are none.
#include "gudgeon/analysis/slider_coordinates.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

namespace gudgeon {

namespace {

/// [rad/s, m/s^2] below this a body rests: rounding of a projected constraint, far below any motion.
constexpr double kAtRest = 1e-9;

/// Largest magnitudes of all channels of a stage; 0 where nothing is known.
class Magnitudes {
 public:
  explicit Magnitudes(const StageRecord& stage) {
    for (const ChannelStatistics& statistics : stage.statistics) {
      of_.emplace(statistics.channel, std::abs(statistics.peak()));
    }
    for (std::size_t k = 0; k < std::min(stage.channels.size(), stage.values.size()); ++k) {
      const auto [known, is_new] = of_.emplace(stage.channels[k].name, 0.0);
      if (!is_new) continue;
      for (const double value : stage.values[k]) known->second = std::max(known->second, std::abs(value));
    }
  }

  [[nodiscard]] double find(const std::string& channel) const {
    const auto known = of_.find(channel);
    return known == of_.end() ? 0.0 : known->second;
  }

 private:
  std::unordered_map<std::string_view, double> of_;
};

}  // namespace

std::vector<std::string> find_slider_coordinates(const StageRecord& stage) {
  constexpr std::string_view kSuffix = ".x_acceleration";
  const Magnitudes magnitudes(stage);
  std::vector<std::string> coordinates;
  for (const Channel& channel : stage.channels) {
    if (!channel.name.ends_with(kSuffix)) continue;
    const std::string body = channel.name.substr(0, channel.name.size() - kSuffix.size());
    if (magnitudes.find(body + ".angle_rate") > kAtRest) continue;
    for (const char* axis : {".x", ".y"}) {
      const std::string coordinate = body + axis;
      if (magnitudes.find(coordinate + "_acceleration") > kAtRest) coordinates.push_back(coordinate);
    }
  }
  return coordinates;
}

}  // namespace gudgeon
