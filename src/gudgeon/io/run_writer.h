// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a run to HDF5, stage by stage. The layout is described in docs/guide/run_file.md.
#pragma once

#include <filesystem>
#include <span>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Writes a run file stage by stage. The file on disk is complete and readable after every call: each call writes a
/// copy beside it ("x.h5.partial") and renames it over the old one, so a kill or a full disk never spoils what was
/// finished. Several writers may work on several files from several threads.
class RunWriter {
 public:
  /// Creates the file with everything but the header's own stages, and with the stages given. FileError when it exists
  /// and may not be replaced, or cannot be written.
  RunWriter(std::filesystem::path file, const RunRecord& header, bool overwrite,
            std::span<const StageRecord> stages = {});

  /// Adds a stage; FileError when it cannot be written, and the file is as it was.
  void append(const StageRecord& stage);

 private:
  std::filesystem::path file_;
};

}  // namespace gudgeon
