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
    surfaces.push_back({state.name, state.stage, find_stage_color(run, state.stage), find_wear(*stage, joint), {}});
    surfaces.back().state = std::move(state);
  }
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
  for (const auto& [joint, surfaces] : joints) {
    add_wear_figure(figures, make_unrolled_figure(surfaces, true), joint + ".bearing_surface",
                    fmt::format("Bearing surface of {}, enlarged", joint),
                    "The rebuilt surface about its deepest place; a bearing grows where it wears.");
    add_wear_figure(figures, make_unrolled_figure(surfaces, false), joint + ".journal_surface",
                    fmt::format("Journal surface of {}, enlarged", joint),
                    "The rebuilt surface about its deepest place; a journal shrinks where it wears.");
  }
  return figures;
}

}  // namespace gudgeon
