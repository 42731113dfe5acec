// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Figures that set cases side by side.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// One case among those that are compared.
struct ComparedCase {
  std::string label;                                        ///< what tells it from the others, "0.3 mm"
  double value = std::numeric_limits<double>::quiet_NaN();  ///< the same in SI; NaN where it is no number
  const RunRecord* run = nullptr;                           ///< an outline does
};

struct CaseComparison {
  std::string id;     ///< "clearance"
  std::string title;  ///< "over clearance"
  FigureAxis axis;    ///< of the values: label and unit
  std::vector<ComparedCase> cases;
};

/// Wear depth and rebuilt surfaces of every joint after the last stage of each case, then trends.
std::vector<Figure> make_comparison_figures(std::span<const CaseComparison> comparisons);

/// The joints with clearance of all its cases, each once.
std::vector<std::string> find_compared_joints(const CaseComparison& comparison);
/// Deepest wear and largest contact force of every joint after the last stage, over the value that the cases differ in;
/// nothing where that is no number.
std::vector<Figure> make_trend_figures(const CaseComparison& comparison);

}  // namespace gudgeon
