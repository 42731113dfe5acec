// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One case's worn surfaces, joint after joint.
#include <fmt/format.h>

#include <utility>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/wear_curves.h"

namespace gudgeon {

namespace {

std::vector<WornSurfaces> find_worn_surfaces(const RunRecord& run, const std::string& joint) {
  std::vector<WornSurfaces> surfaces;
  for (WearState& state : find_wear_states(run, joint)) {
    const StageRecord* stage = find_stage(run, state.stage);
    surfaces.push_back({state.name, state.stage, find_stage_color(run, state.stage), 1, find_wear(*stage, joint), {}});
    surfaces.back().state = std::move(state);
  }
  for (WornSurfaces& one : surfaces) one.n_alike = static_cast<int>(surfaces.size());
  return surfaces;
}

void add_wear_figure(std::vector<Figure>& figures, Figure figure, std::string id, std::string title,
                     std::string_view caption) {
  if (figure.curves.empty()) return;
  figure.id = std::move(id);
  figure.topic = "wear";
  figure.title = std::move(title);
  if (figure.caption.empty()) figure.caption = caption;
  figures.push_back(std::move(figure));
}

/// Both sides of a joint as they are worn, unrolled.
void add_unrolled_figures(std::vector<Figure>& figures, const std::string& joint,
                          const std::vector<WornSurfaces>& surfaces) {
  if (surfaces.empty()) return;
  const bool is_slot = surfaces.front().wear->slot_length > 0.0;
  const bool is_block = split_journal(*surfaces.front().wear, surfaces.front().state.journal_depth).size() > 1;
  add_wear_figure(figures, make_unrolled_figure(surfaces, true), joint + ".bearing_surface",
                  fmt::format("{} of {}, enlarged", is_slot ? "Sides of the slot" : "Bearing surface", joint),
                  is_slot ? "The rebuilt sides about their deepest places."
                          : "The rebuilt surface about its deepest place; a bearing grows where it wears.");
  add_wear_figure(figures, make_unrolled_figure(surfaces, false), joint + ".journal_surface",
                  fmt::format("{} of {}, enlarged", is_block ? "Corners of the block" : "Journal surface", joint),
                  is_block ? "The rebuilt corners about their deepest places; they shrink where they wear."
                           : "The rebuilt surface about its deepest place; a journal shrinks where it wears.");
}

}  // namespace

std::vector<Figure> make_wear_figures(const RunRecord& run) {
  std::vector<Figure> figures;
  std::vector<std::pair<std::string, std::vector<WornSurfaces>>> joints;
  for (const std::string& joint : find_clearance_joints(run))
    joints.emplace_back(joint, find_worn_surfaces(run, joint));
  // Joint beside joint, so that pictures of one kind stand together.
  for (const auto& [joint, surfaces] : joints) {
    add_wear_figure(figures, make_depth_figure(surfaces), joint + ".wear_depth", fmt::format("Wear depth in {}", joint),
                    "Bearing and journal together, over the surface of the bearing.");
  }
  for (const auto& [joint, surfaces] : joints) {
    add_wear_figure(figures, make_outline_figure(surfaces), joint + ".surfaces",
                    fmt::format("Rebuilt surfaces of {}", joint), "");
  }
  for (const auto& [joint, surfaces] : joints) add_unrolled_figures(figures, joint, surfaces);
  return figures;
}

}  // namespace gudgeon
