// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Worn surfaces, state after state.
#include "gudgeon/report/figures/wear_states.h"

#include <algorithm>
#include <array>
#include <span>

#include "gudgeon/analysis/wear_summary.h"
#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/results/cells.h"

namespace gudgeon {

namespace {

bool has_depth(const std::vector<double>& depth) {
  return std::ranges::any_of(depth, [](double d) { return d > 0.0; });
}

SurfaceProfile make_round(const char* name, double radius, double outwards, std::span<const double> depth) {
  SurfaceProfile profile{name, std::string("Angle in the ") + name, "rad", radius, -1, outwards, nullptr, nullptr};
  std::vector<double> angles;
  for (std::size_t k = 0; k < depth.size(); ++k) angles.push_back(find_cell_angle(k, depth.size()));
  profile.position = make_numbers(std::move(angles));
  profile.depth = make_numbers({depth.begin(), depth.end()});
  return profile;
}

/// One side of a slot, from its rear to its front end.
SurfaceProfile make_side(const char* name, int part, double length, std::span<const double> depth) {
  SurfaceProfile profile{name, "Place along the slot", "m", 0.0, part, 1.0, nullptr, nullptr};
  std::vector<double> places;
  for (std::size_t k = 0; k < depth.size(); ++k) places.push_back(find_cell_position(k, depth.size(), length));
  profile.position = make_numbers(std::move(places));
  profile.depth = make_numbers({depth.begin(), depth.end()});
  return profile;
}

}  // namespace

std::vector<WearState> find_wear_states(const RunRecord& run, const std::string& joint) {
  std::vector<WearState> states;
  for (std::size_t k = 1; k < run.stages.size(); ++k) {
    const JointWear* wear = find_wear(run.stages[k], joint);
    if (wear == nullptr || !(has_depth(wear->bearing_depth) || has_depth(wear->journal_depth))) continue;
    states.push_back({label_stage(run.stages[k].name), run.stages[k].name, wear->bearing_depth, wear->journal_depth,
                      find_accumulated_depth(run, k - 1, joint)});
  }
  if (!states.empty() || run.stages.empty()) return states;
  const StageRecord& last = run.stages.back();
  const JointWear* wear = find_wear(last, joint);
  if (wear == nullptr || !has_depth(wear->total_depth_added)) return states;
  states.push_back({"after " + label_stage(last.name), last.name, wear->bearing_depth_after(),
                    wear->journal_depth_after(), find_accumulated_depth(run, run.stages.size() - 1, joint)});
  return states;
}

std::vector<SurfaceProfile> split_bearing(const JointWear& wear, const std::vector<double>& depth) {
  if (!(wear.slot_length > 0.0)) return {make_round("bearing", wear.bearing_radius, 1.0, depth)};
  const std::size_t n = depth.size() / 2;
  return {make_side("left side", 0, wear.slot_length, std::span(depth).first(n)),
          make_side("right side", 1, wear.slot_length, std::span(depth).last(n))};
}

std::vector<SurfaceProfile> split_journal(const JointWear& wear, const std::vector<double>& depth) {
  static constexpr std::array kCorners{"left rear corner", "left front corner", "right rear corner",
                                       "right front corner"};
  const std::size_t n = wear.slot_length > 0.0 ? wear.n_cells() : depth.size();
  if (n == 0 || depth.size() != n * kCorners.size()) {
    return {make_round("journal", wear.journal_radius, -1.0, depth)};
  }
  std::vector<SurfaceProfile> corners;
  for (std::size_t c = 0; c < kCorners.size(); ++c) {
    corners.push_back(make_round("block", wear.journal_radius, -1.0, std::span(depth).subspan(c * n, n)));
    corners.back().name = kCorners[c];
    corners.back().part = static_cast<int>(c);
  }
  return corners;
}

}  // namespace gudgeon
