// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A run as CSV files, for spreadsheets and scripts.
#pragma once

#include <filesystem>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Writes into the directory, which is made when missing, for every stage
///   STAGE_channels.csv    time and every channel whose values were read, a row a sample
///   STAGE_statistics.csv  a row a channel
///   STAGE_wear.csv        a row a region of each joint, with the angle of the region's middle
///   STAGE_events.csv      a row a stay in contact
///   STAGE_energy.csv      a row a term of the ledger
/// in SI and radians, numbers as short as they still read back to the same double, an empty cell where there is no
/// number. Wear and events are left out of a stage without clearance joints. Returns what was written. FileError when
/// a file cannot be written, or one of them exists and may not be replaced (then none is written).
std::vector<std::filesystem::path> export_csv(const RunRecord& run, const std::filesystem::path& directory,
                                              bool overwrite);

/// Writes STAGE_channels.csv and STAGE_statistics.csv of one stage in the same way.
std::vector<std::filesystem::path> export_motion(const StageRecord& stage, const std::filesystem::path& directory,
                                                 bool overwrite);

}  // namespace gudgeon
