// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The checkpoint of a case, in a file of its own beside the case's run file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gudgeon/results/checkpoint.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// A stage under way, and what the writer of its run file needs to have the samples again that it was handed.
struct SavedCheckpoint {
  Checkpoint checkpoint;
  std::string written;
};

/// "x.h5.checkpoint"
std::filesystem::path find_checkpoint_file(const std::filesystem::path& run_file);

/// Replaces the one before; a kill leaves the one or the other. FileError when it cannot be written.
void write_checkpoint(const std::filesystem::path& run_file, const RunRecord& header, const SavedCheckpoint& saved);

/// Nothing when there is none. FileError with the path when it is damaged, or not of a run with this header.
std::optional<SavedCheckpoint> read_checkpoint(const std::filesystem::path& run_file, const RunRecord& header);

void remove_checkpoint(const std::filesystem::path& run_file);

}  // namespace gudgeon
