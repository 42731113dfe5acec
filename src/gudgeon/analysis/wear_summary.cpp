// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Depth profiles added up, searched for their largest value and cut into worn ranges.
#include "gudgeon/analysis/wear_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/results/cells.h"

namespace gudgeon {

namespace {

/// sum += added; an empty sum takes the size of the first profile.
void add_profile(std::vector<double>& sum, std::span<const double> added, const std::string& joint) {
  if (added.empty()) return;
  if (sum.empty()) sum.assign(added.size(), 0.0);
  if (sum.size() != added.size()) {
    throw NumericalError(
        fmt::format("joint '{}': wear profiles of {} and {} cells cannot be added up; run all "
                    "stages with the same number of cells",
                    joint, sum.size(), added.size()));
  }
  std::ranges::transform(sum, added, sum.begin(), std::plus<>());
}

// The deepest cell of surfaces that stand one after the other, each of n cells.
DeepestPoint find_deepest_of(std::span<const double> depth, const JointWear& wear) {
  DeepestPoint point = find_deepest(depth);
  const std::size_t n = wear.n_cells();
  if (wear.slot_length == 0.0 || n == 0 || point.depth == 0.0) return point;
  const auto k = static_cast<std::size_t>(std::ranges::max_element(depth) - depth.begin());
  point.surface = k / n;
  point.angle = find_cell_angle(k % n, n);
  point.position = find_cell_position(k % n, n, wear.slot_length);
  return point;
}

DeepestPoint find_deepest_sum(std::span<const double> worn, std::span<const double> added, const JointWear& wear) {
  std::vector<double> sum(worn.begin(), worn.end());
  add_profile(sum, added, wear.joint);
  return find_deepest_of(sum, wear);
}

double find_mean(std::span<const double> depth) {
  if (depth.empty()) return 0.0;
  return std::accumulate(depth.begin(), depth.end(), 0.0) / static_cast<double>(depth.size());
}

}  // namespace

DeepestPoint find_deepest(std::span<const double> depth) {
  if (depth.empty()) return {};
  const auto deepest = std::ranges::max_element(depth);
  if (!(*deepest > 0.0)) return {};
  return {*deepest, find_cell_angle(static_cast<std::size_t>(deepest - depth.begin()), depth.size())};
}

std::vector<AngleRange> find_worn_ranges(std::span<const double> depth, double fraction) {
  const std::size_t n = depth.size();
  const double threshold = fraction * find_deepest(depth).depth;
  const auto is_worn = [&](std::size_t k) { return depth[k % n] > threshold; };
  const auto degrees = [n](std::size_t k) { return 360.0 * static_cast<double>(k) / static_cast<double>(n); };
  std::size_t first_free = 0;
  while (first_free < n && is_worn(first_free)) ++first_free;
  if (n == 0 || std::ranges::none_of(depth, [&](double d) { return d > threshold; })) return {};
  if (first_free == n) return {{0.0, 360.0}};

  // once around from an unworn cell, so that no range is cut at 0
  std::vector<AngleRange> ranges;
  for (std::size_t k = first_free; k < first_free + n; ++k) {
    if (!is_worn(k)) continue;
    const std::size_t begin = k;
    while (is_worn(k)) ++k;
    ranges.push_back({degrees(begin % n), degrees(begin % n + (k - begin))});
  }
  std::ranges::sort(ranges, {}, &AngleRange::begin);
  return ranges;
}

std::vector<SideRange> find_worn_sides(std::span<const double> depth, double length, double fraction) {
  const std::size_t n = depth.size() / 2;
  const double threshold = fraction * find_deepest(depth).depth;
  const double cell = n > 0 ? length / static_cast<double>(n) : 0.0;
  std::vector<SideRange> ranges;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::span<const double> at = depth.subspan(side * n, n);
    for (std::size_t k = 0; k < n; ++k) {
      if (!(at[k] > threshold)) continue;
      const std::size_t begin = k;
      while (k < n && at[k] > threshold) ++k;
      const auto edge = [&](std::size_t cell_edge) { return cell * static_cast<double>(cell_edge) - 0.5 * length; };
      ranges.push_back({side, edge(begin), edge(k)});
    }
  }
  return ranges;
}

std::vector<double> find_accumulated_depth(const RunRecord& run, std::size_t stage_index, const std::string& joint) {
  std::vector<double> sum;
  for (std::size_t k = 0; k <= stage_index && k < run.stages.size(); ++k) {
    const auto wear = std::ranges::find(run.stages[k].wear, joint, &JointWear::joint);
    if (wear != run.stages[k].wear.end()) add_profile(sum, wear->total_depth_added, joint);
  }
  return sum;
}

std::vector<JointWearSummary> summarize_wear(const RunRecord& run, std::size_t stage_index) {
  std::vector<JointWearSummary> summaries;
  for (const JointWear& wear : run.stages.at(stage_index).wear) {
    const std::vector<double> accumulated = find_accumulated_depth(run, stage_index, wear.joint);
    JointWearSummary& summary = summaries.emplace_back();
    summary.joint = wear.joint;
    summary.is_slot = wear.slot_length > 0.0;
    summary.added = find_deepest_of(wear.total_depth_added, wear);
    summary.accumulated = find_deepest_of(accumulated, wear);
    summary.bearing = find_deepest_sum(wear.bearing_depth, wear.bearing_depth_added, wear);
    summary.journal = find_deepest_sum(wear.journal_depth, wear.journal_depth_added, wear);
    summary.mean_depth_added = find_mean(wear.total_depth_added);
    if (summary.is_slot) {
      summary.worn_sides = find_worn_sides(accumulated, wear.slot_length);
    } else {
      summary.worn = find_worn_ranges(accumulated);
    }
    summary.removed_volume = wear.removed_volume;
    summary.archard_volume = wear.archard_volume;
    summary.clearance_share = wear.clearance > 0.0 ? summary.added.depth / wear.clearance : 0.0;
  }
  return summaries;
}

}  // namespace gudgeon
