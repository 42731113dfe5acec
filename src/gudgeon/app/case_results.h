// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a run leaves on screen: a summary of each case, the paths, and what went wrong.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/app/case_runner.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// The summary of a run whose samples lie in the case's file, as far as it needs them. FileError when they cannot be
/// read.
std::string summarize_case(const CaseRun& one, RunRecord run);

/// Summaries and paths to standard output, errors to standard error; quiet leaves the summaries out.
/// FileError when a file cannot be read back or standard output takes no more.
void print_results(const std::vector<CaseRun>& cases, bool quiet);

}  // namespace gudgeon
