// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Figures and motions as the page reads them.
#pragma once

#include <vector>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/report/figures/signals.h"
#include "gudgeon/report/html/block_store.h"
#include "gudgeon/report/html/json_text.h"
#include "gudgeon/report/html/report_case.h"
#include "gudgeon/report/html/signal_detail.h"

namespace gudgeon {

/// The last samples of a signal with that many samples a cycle that stay in full.
std::size_t find_full_count(double full_cycles, std::size_t cycle_samples);

/// Adds the figure; signals before the last full cycles are reduced, trajectories begin there.
void add_figure(JsonText& json, BlockStore& blocks, const Figure& figure, const SignalDetail& detail);

/// Channels of a stage that the animation shows.
std::vector<std::string> find_pose_channels(const Scene& scene, const StageRecord& stage);

/// Adds bodies and joints.
void add_scene(JsonText& json, const Scene& scene, const RunRecord& run);
/// Adds, of every stage, poses, places of journals and joint forces over the last full_cycles.
void add_motions(JsonText& json, BlockStore& blocks, const Scene& scene, Signals& signals, double full_cycles);

}  // namespace gudgeon
