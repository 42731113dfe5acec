// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The last surfaces of each case over each other.
#include "gudgeon/report/figures/comparison_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/wear_curves.h"

namespace gudgeon {

namespace {

std::vector<std::string> find_compared_joints(const CaseComparison& comparison) {
  std::vector<std::string> joints;
  for (const ComparedCase& one : comparison.cases) {
    for (const std::string& joint : find_clearance_joints(*one.run)) {
      if (std::ranges::find(joints, joint) == joints.end()) joints.push_back(joint);
    }
  }
  return joints;
}

std::vector<WornSurfaces> find_last_surfaces(const CaseComparison& comparison, const std::string& joint) {
  std::vector<WornSurfaces> surfaces;
  int color = 0;
  for (const ComparedCase& one : comparison.cases) {
    ++color;
    std::vector<WearState> states = find_wear_states(*one.run, joint);
    if (states.empty()) continue;
    const StageRecord* stage = find_stage(*one.run, states.back().stage);
    surfaces.push_back({fmt::format("{}: {}", one.label, states.back().name), one.run->case_name, color,
                        find_wear(*stage, joint), std::move(states.back())});
  }
  return surfaces;
}

}  // namespace

std::vector<Figure> make_comparison_figures(std::span<const CaseComparison> comparisons) {
  std::vector<Figure> figures;
  for (const CaseComparison& comparison : comparisons) {
    for (const std::string& joint : find_compared_joints(comparison)) {
      const std::vector<WornSurfaces> surfaces = find_last_surfaces(comparison, joint);
      const auto add = [&](Figure figure, const char* what, std::string title) {
        if (figure.curves.size() < 2) return;
        figure.id = fmt::format("{}.{}_over_{}", joint, what, comparison.id);
        figure.topic = "comparison";
        figure.title = std::move(title);
        if (figure.caption.empty()) figure.caption = "Bearing and journal together, after the last stage of each case.";
        figures.push_back(std::move(figure));
      };
      add(make_depth_figure(surfaces), "wear_depth", fmt::format("Wear depth in {} {}", joint, comparison.title));
      add(make_outline_figure(surfaces), "surfaces", fmt::format("Rebuilt surfaces of {} {}", joint, comparison.title));
    }
  }
  return figures;
}

}  // namespace gudgeon
