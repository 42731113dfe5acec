// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a run file back. Every error, also a damaged or foreign file, is a FileError.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Everything.
RunRecord read_run(const std::filesystem::path& file);

/// All but the stages.
RunRecord read_run_header(const std::filesystem::path& file);

/// All but StageRecord::values and time; values has an empty vector for each channel.
RunRecord read_run_outline(const std::filesystem::path& file);

/// The channels of a stage whose values are wanted.
using ChooseChannels = std::function<std::vector<std::string>(const StageRecord& stage)>;

/// Fills time and the values of the chosen channels of stages from read_run_outline; leaves other values as they are.
void read_channels(const std::filesystem::path& file, std::span<StageRecord> stages, const ChooseChannels& choose);

}  // namespace gudgeon
