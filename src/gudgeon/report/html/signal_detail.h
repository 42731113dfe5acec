// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How much of a run is shown sample by sample.
#pragma once

#include <cstddef>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// [bytes] that the numbers of a page may take, of the 15 MB that mail and browsers take well; the rest is for model
/// texts, tables, script.
inline constexpr std::size_t kPageNumbers = 11'500'000;

/// Cycles at the end of every stage that the page can hold in full within so many bytes; at most kMostFullCycles.
double find_full_cycles(const RunRecord& run, std::size_t bytes);

/// More would be slow to draw as an orbit and no easier to read.
inline constexpr double kMostFullCycles = 20.0;

}  // namespace gudgeon
