// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// All figures of one case, in the order of a paper's results.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/report/figures/signals.h"

namespace gudgeon {

/// The channels of a stage that its figures show.
std::vector<std::string> find_figure_channels(const RunRecord& outline, const StageRecord& stage);

/// Figures for all that was recorded and read; what a run does not have gives no figure.
std::vector<Figure> make_case_figures(Signals& signals);

// One topic each.
std::vector<Figure> make_wear_figures(const RunRecord& run);
std::vector<Figure> make_motion_figures(Signals& signals);
std::vector<Figure> make_drive_figures(Signals& signals);
std::vector<Figure> make_contact_figures(Signals& signals);
std::vector<Figure> make_journal_figures(Signals& signals);

/// The clearance joints of a run, each once.
std::vector<std::string> find_clearance_joints(const RunRecord& run);
/// The joint's wear in a stage; nullptr when the stage has none.
const JointWear* find_wear(const StageRecord& stage, const std::string& joint);
/// Channels of displacement, velocity and acceleration of the sliders, in that order body after body; of the angle of
/// the last body where nothing slides.
std::vector<std::string> find_motion_channels(const RunRecord& run);
/// Drivers' efforts, from any stage.
std::vector<Channel> find_effort_channels(const RunRecord& run);

}  // namespace gudgeon
