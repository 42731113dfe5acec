// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Counting the bytes of a page before it is written.
#include "gudgeon/report/html/full_cycles.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/signals.h"
#include "gudgeon/report/html/reduced_signal.h"

namespace gudgeon {

namespace {

constexpr double kBytesAValue = 4.0 * 4.0 / 3.0;  // single precision in base64

}  // namespace

double find_full_cycles(const RunRecord& run, std::size_t bytes) {
  const auto n_motions = static_cast<double>(find_motion_channels(run).size());
  // Signals over time keep their reduced past: motions with their errors, efforts, contact forces, the time itself,
  // which is of double precision.
  const double n_over_time = 2.0 * n_motions + static_cast<double>(find_effort_channels(run).size()) +
                             static_cast<double>(find_clearance_joints(run).size()) + 2.0;
  double reduced = 0.0;    // [bytes] whatever the number of full cycles
  double per_cycle = 0.0;  // [bytes]
  for (const StageRecord& stage : run.stages) {
    const auto n_read = std::ranges::count_if(stage.values, [](const auto& values) { return !values.empty(); });
    const double n_signals = static_cast<double>(n_read) + n_motions + 2.0;
    reduced += kBytesAValue * n_over_time * std::min(2.0 * kReducedSpans, static_cast<double>(stage.time.size()));
    per_cycle += kBytesAValue * n_signals * static_cast<double>(find_cycle_samples(stage));
  }
  if (!(per_cycle > 0.0)) return kMostFullCycles;
  const double cycles = std::max(0.0, static_cast<double>(bytes) - reduced) / per_cycle;
  // A whole number of cycles where there is room for one; a tenth of a cycle still moves.
  return cycles >= 1.0 ? std::min(std::floor(cycles), kMostFullCycles) : std::max(cycles, 0.1);
}

}  // namespace gudgeon
