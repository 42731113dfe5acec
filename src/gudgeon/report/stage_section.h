// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sections of the summary that set the stages side by side. A section with nothing to say is an empty text.
#pragma once

#include <string>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// "finished", "stopped", "failed".
const char* name_status(StageStatus status);

/// What each stage took, and why it ended when it did not finish.
std::string render_stages(const RunRecord& run, bool color);

/// Penetrations and depths of wear that no bearing has, a line each.
std::string render_limits_exceeded(const RunRecord& run, bool color);

/// Peaks of contact forces, driver efforts and slider accelerations that have statistics, a column a stage.
std::string render_peaks(const RunRecord& run, bool color);

/// The energy balance, a column a stage, with its residual against the energy exchanged.
std::string render_energy(const RunRecord& run, bool color);

}  // namespace gudgeon
