// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Figures that set cases side by side.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// One case among those that are compared.
struct ComparedCase {
  std::string label;               ///< what tells it from the others, "0.3 mm"
  const RunRecord* run = nullptr;  ///< an outline does
};

struct CaseComparison {
  std::string id;     ///< "clearance"
  std::string title;  ///< "over clearance"
  std::vector<ComparedCase> cases;
};

/// Wear depth and rebuilt surfaces of every joint after the last stage of each case, and peaks over the cases.
std::vector<Figure> make_comparison_figures(std::span<const CaseComparison> comparisons);

}  // namespace gudgeon
