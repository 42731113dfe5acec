// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which cases differ in nothing but their clearances, or in nothing but their speeds.
#pragma once

#include <span>
#include <vector>

#include "gudgeon/app/report_runs.h"
#include "gudgeon/report/figures/comparison_figures.h"

namespace gudgeon {

/// Comparisons over clearance and over speed; when there is neither, one over all cases.
std::vector<CaseComparison> group_cases(std::span<const ReadRun> runs);

}  // namespace gudgeon
