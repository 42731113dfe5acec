// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The last surfaces of each case over each other.
#include "gudgeon/report/figures/comparison_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/wear_curves.h"

namespace gudgeon {

namespace {

/// As many as there are colours.
constexpr std::size_t kMostCompared = 7;

/// The comparison itself, or cases at equal steps of it from the first to the last.
CaseComparison select_cases(const CaseComparison& comparison) {
  const std::size_t n = comparison.cases.size();
  if (n <= kMostCompared) return comparison;
  CaseComparison selected{comparison.id, comparison.title, comparison.axis, {}};
  for (std::size_t k = 0; k < kMostCompared; ++k) {
    selected.cases.push_back(comparison.cases[k * (n - 1) / (kMostCompared - 1)]);
  }
  return selected;
}

std::vector<WornSurfaces> find_last_surfaces(const CaseComparison& comparison, const std::string& joint) {
  std::vector<WornSurfaces> surfaces;
  int color = 0;
  for (const ComparedCase& one : comparison.cases) {
    ++color;
    std::vector<WearState> states = find_wear_states(*one.run, joint);
    if (states.empty()) continue;
    const StageRecord* stage = find_stage(*one.run, states.back().stage);
    surfaces.push_back({fmt::format("{}: {}", one.label, states.back().name), one.run->case_name, color, 1,
                        find_wear(*stage, joint), std::move(states.back())});
  }
  for (WornSurfaces& one : surfaces) one.n_alike = static_cast<int>(surfaces.size());
  return surfaces;
}

}  // namespace

std::vector<Figure> make_comparison_figures(std::span<const CaseComparison> comparisons) {
  std::vector<Figure> figures;
  for (const CaseComparison& whole : comparisons) {
    const CaseComparison comparison = select_cases(whole);
    const bool is_selection = comparison.cases.size() < whole.cases.size();
    for (const std::string& joint : find_compared_joints(comparison)) {
      const std::vector<WornSurfaces> surfaces = find_last_surfaces(comparison, joint);
      const auto add = [&](Figure figure, const char* what, std::string title) {
        if (figure.curves.size() < 2) return;
        figure.id = fmt::format("{}.{}_over_{}", joint, what, comparison.id);
        figure.topic = "comparison";
        figure.title = std::move(title);
        if (figure.caption.empty()) {
          figure.caption =
              "Bearing and journal together, as the last stage of each case runs on them; what it wears away itself "
              "comes on top.";
        }
        if (is_selection) {
          figure.caption +=
              fmt::format(" {} of {} cases, at equal steps.", comparison.cases.size(), whole.cases.size());
        }
        figures.push_back(std::move(figure));
      };
      add(make_depth_figure(surfaces), "wear_depth", fmt::format("Wear depth in {} {}", joint, comparison.title));
      add(make_outline_figure(surfaces), "surfaces", fmt::format("Rebuilt surfaces of {} {}", joint, comparison.title));
    }
    std::ranges::move(make_trend_figures(whole), std::back_inserter(figures));
  }
  return figures;
}

}  // namespace gudgeon
