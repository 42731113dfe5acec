// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Looks at channel statistics first and at recorded values where there are none.
#include "gudgeon/analysis/translating_bodies.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace gudgeon {

namespace {

/// [rad/s, m/s^2] below this a body rests: rounding of a projected constraint, far below any motion.
constexpr double kAtRest = 1e-9;

/// Largest magnitude a channel is known to have; 0 when nothing is known.
double find_magnitude(const StageRecord& stage, const std::string& channel) {
  if (const ChannelStatistics* statistics = find_statistics(stage, channel)) return std::abs(statistics->peak());
  double magnitude = 0.0;
  if (const std::vector<double>* values = find_values(stage, channel)) {
    for (const double value : *values) magnitude = std::max(magnitude, std::abs(value));
  }
  return magnitude;
}

}  // namespace

std::vector<std::string> find_moving_axes(const StageRecord& stage, const std::string& body) {
  std::vector<std::string> axes;
  for (const char* axis : {"x", "y"}) {
    if (find_magnitude(stage, body + "." + axis + "_acceleration") > kAtRest) axes.emplace_back(axis);
  }
  return axes;
}

std::vector<std::string> find_translating_bodies(const StageRecord& stage) {
  constexpr std::string_view kSuffix = ".x_acceleration";
  std::vector<std::string> bodies;
  for (const Channel& channel : stage.channels) {
    if (!channel.name.ends_with(kSuffix)) continue;
    const std::string body = channel.name.substr(0, channel.name.size() - kSuffix.size());
    const bool turns = find_magnitude(stage, body + ".angle_rate") > kAtRest;
    if (!turns && !find_moving_axes(stage, body).empty()) bodies.push_back(body);
  }
  return bodies;
}

}  // namespace gudgeon
