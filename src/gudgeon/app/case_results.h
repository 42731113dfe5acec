// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a run leaves on screen: a summary of each case, the paths, and what went wrong.
#pragma once

#include <vector>

#include "gudgeon/app/case_runner.h"

namespace gudgeon {

/// Summaries and paths to standard output, errors to standard error; quiet leaves the summaries out.
/// FileError when a file cannot be read back or standard output takes no more.
void print_results(const std::vector<CaseRun>& cases, bool quiet);

}  // namespace gudgeon
