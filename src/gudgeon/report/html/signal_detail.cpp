// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Counting the bytes of a page before it is written.
#include "gudgeon/report/html/signal_detail.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/signals.h"
#include "gudgeon/report/html/reduced_signal.h"

namespace gudgeon {

namespace {

constexpr double kBytesAValue = 4.0 * 4.0 / 3.0;  // single precision in base64
constexpr std::size_t kFewestSpans = 125;         // a line of fewer would no longer show its shape

/// Signals over time, which keep their reduced past: motions with their errors, efforts, contact forces, and the time
/// itself, which is of double precision.
double count_signals_over_time(const RunRecord& run) {
  return 2.0 * static_cast<double>(find_motion_channels(run).size()) +
         static_cast<double>(find_effort_channels(run).size() + find_clearance_joints(run).size()) + 2.0;
}

/// [bytes] of all that is reduced, whatever the number of full cycles.
double find_reduced_size(const RunRecord& run, std::size_t n_spans) {
  double n_values = 0.0;
  for (const StageRecord& stage : run.stages) {
    n_values += std::min(2.0 * static_cast<double>(n_spans), static_cast<double>(stage.time.size()));
  }
  return kBytesAValue * count_signals_over_time(run) * n_values;
}

/// [bytes] of one full cycle of all stages.
double find_cycle_size(const RunRecord& run) {
  const auto n_motions = static_cast<double>(find_motion_channels(run).size());
  double n_values = 0.0;
  for (const StageRecord& stage : run.stages) {
    const auto n_read = std::ranges::count_if(stage.values, [](const auto& values) { return !values.empty(); });
    n_values += (static_cast<double>(n_read) + n_motions + 2.0) * static_cast<double>(find_cycle_samples(stage));
  }
  return kBytesAValue * n_values;
}

}  // namespace

SignalDetail find_signal_detail(const RunRecord& run, std::size_t bytes) {
  SignalDetail detail{kMostFullCycles, kReducedSpans, true};
  const auto room = static_cast<double>(bytes);
  // The last cycles are what is looked at: at least half the room is theirs.
  while (detail.n_spans > kFewestSpans && find_reduced_size(run, detail.n_spans) > 0.5 * room) detail.n_spans /= 2;
  const double cycle_size = find_cycle_size(run);
  if (!(cycle_size > 0.0)) return detail;
  const double cycles = std::max(0.0, room - find_reduced_size(run, detail.n_spans)) / cycle_size;
  // A whole number of cycles where there is room for one; a tenth of a cycle still moves.
  detail.full_cycles = cycles >= 1.0 ? std::min(std::floor(cycles), kMostFullCycles) : std::max(cycles, 0.1);
  return detail;
}

std::size_t find_fixed_size(std::span<const Figure> figures) {
  std::size_t n_values = 0;
  for (const Figure& figure : figures) {
    for (const FigureCurve& curve : figure.curves) n_values += curve.cycle_samples == 0 ? 2 * curve.x->size() : 0;
  }
  return static_cast<std::size_t>(kBytesAValue * static_cast<double>(n_values));
}

}  // namespace gudgeon
