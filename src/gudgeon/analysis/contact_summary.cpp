// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Contact events added up a joint.
#include "gudgeon/analysis/contact_summary.h"

#include <algorithm>

namespace gudgeon {

namespace {

/// [s] of a stay that lie within the counted cycles.
double find_counted_time(const StageRecord& stage, const ContactEvent& event) {
  const double begin = std::max(event.onset_time, stage.start_time);
  const double end = std::min(event.onset_time + event.duration, stage.end_time);
  return std::max(end - begin, 0.0);
}

double find_part(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

JointContactSummary summarize_joint(const StageRecord& stage, std::size_t joint) {
  const JointWear& wear = stage.wear[joint];
  JointContactSummary summary;
  summary.joint = wear.joint;
  double lasting = 0.0;
  double all = 0.0;
  for (const ContactEvent& event : stage.events) {
    if (static_cast<std::size_t>(event.joint) != joint) continue;
    ++summary.onsets;
    const double counted = find_counted_time(stage, event);
    all += counted;
    if (event.duration > kLastingFraction * stage.cycle_time) lasting += counted;
    summary.largest_force = std::max(summary.largest_force, event.peak_force);
  }
  summary.contact_fraction = find_part(wear.contact_time, stage.end_time - stage.start_time);
  summary.flight_fraction = std::max(1.0 - summary.contact_fraction, 0.0);  // times add up to a rounding
  summary.lasting_fraction = find_part(lasting, all);
  summary.impact_fraction = all > 0.0 ? 1.0 - summary.lasting_fraction : 0.0;
  summary.mean_force = find_part(wear.impulse, wear.contact_time);
  // a force the statistics saw may belong to a stay that the events do not hold
  if (const ChannelStatistics* force = find_statistics(stage, wear.joint + ".normal_force")) {
    summary.largest_force = std::max(summary.largest_force, force->maximum);
  }
  return summary;
}

}  // namespace

std::vector<JointContactSummary> summarize_contacts(const StageRecord& stage) {
  std::vector<JointContactSummary> summaries;
  for (std::size_t k = 0; k < stage.wear.size(); ++k) summaries.push_back(summarize_joint(stage, k));
  return summaries;
}

}  // namespace gudgeon
