// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Peaks of penetration and greatest depths against radii and clearance.
#include "gudgeon/analysis/surface_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gudgeon {

namespace {

double find_greatest_depth(const std::vector<double>& before, const std::vector<double>& added) {
  double deepest = 0.0;
  for (std::size_t k = 0; k < std::min(before.size(), added.size()); ++k) {
    deepest = std::max(deepest, before[k] + added[k]);
  }
  return deepest;
}

void check_joint(const StageRecord& stage, const JointWear& wear, std::vector<LimitExceeded>& exceeded) {
  const auto note = [&](SurfaceLimit limit, double reached, double bound, bool of_journal) {
    if (reached > bound) exceeded.push_back({stage.name, wear.joint, limit, reached, bound, of_journal});
  };
  const bool is_round = std::isfinite(wear.bearing_radius);
  if (const ChannelStatistics* penetration = find_statistics(stage, wear.joint + ".penetration")) {
    note(SurfaceLimit::penetration_radius, penetration->maximum, is_round ? wear.bearing_radius : wear.journal_radius,
         !is_round);
  }
  const double bearing = find_greatest_depth(wear.bearing_depth, wear.bearing_depth_added);
  const double journal = find_greatest_depth(wear.journal_depth, wear.journal_depth_added);
  if (is_round) note(SurfaceLimit::wear_radius, bearing, wear.bearing_radius, false);
  note(SurfaceLimit::wear_clearance, std::max(bearing, journal), wear.clearance, journal > bearing);
}

// Lengths of a bearing: "2.19 m", "20 mm", "35.2 um".
std::string print_length(double length) {
  if (length >= 1.0) return fmt::format("{:.4g} m", length);
  return length >= 1e-3 ? fmt::format("{:.4g} mm", 1e3 * length) : fmt::format("{:.4g} um", 1e6 * length);
}

}  // namespace

std::vector<LimitExceeded> find_limits_exceeded(const RunRecord& run) {
  std::vector<LimitExceeded> exceeded;
  for (const StageRecord& stage : run.stages) {
    for (const JointWear& wear : stage.wear) check_joint(stage, wear, exceeded);
  }
  return exceeded;
}

std::string describe(const LimitExceeded& exceeded) {
  const char* surface = exceeded.of_journal ? "journal" : "bearing";
  const std::string reached = print_length(exceeded.reached);
  const std::string bound = print_length(exceeded.bound);
  std::string text = fmt::format("stage '{}', joint '{}': ", exceeded.stage, exceeded.joint);
  switch (exceeded.limit) {
    case SurfaceLimit::penetration_radius:
      text += fmt::format(
          "penetration of {}, beyond the {}'s radius of {}: the contact is far too soft to hold its load, and what "
          "follows from it means nothing; look at the units of its stiffness",
          reached, surface, bound);
      break;
    case SurfaceLimit::wear_radius:
      text += fmt::format(
          "{} worn {} deep, beyond its radius of {}: a wall would be worn through; lower the "
          "wear_acceleration or the wear coefficients",
          surface, reached, bound);
      break;
    case SurfaceLimit::wear_clearance:
      text += fmt::format(
          "{} worn {} deep, more than the clearance of {}: its shape is no longer a small change of a "
          "round or straight one, as the gap and the contact's arc take it to be",
          surface, reached, bound);
      break;
  }
  return text;
}

}  // namespace gudgeon
