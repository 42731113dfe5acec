// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a run to HDF5, stage by stage. The layout is described in docs/guide/run_file.md.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "gudgeon/io/safe_file.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/results/sample_block.h"

namespace gudgeon {

/// Writes a run file stage by stage. The file on disk is complete and readable at any moment: what is added goes into a
/// copy beside it ("x.h5.partial"), which is renamed over the old one when its stage is whole, so a kill or a full disk
/// never spoils what was finished. Several writers may work on several files from several threads.
class RunWriter {
 public:
  /// Creates the file with everything but the header's own stages. FileError when it exists and may not be replaced, or
  /// cannot be written. The stages named kept are taken over from the file that is replaced.
  RunWriter(std::filesystem::path file, const RunRecord& header, bool overwrite,
            std::span<const std::string> kept = {});

  /// Adds samples of a stage under way to the partial file, so that they need not stay in memory; FileError when they
  /// cannot be written: the partial file is gone, and the file is as it was.
  void append(const SampleBlock& block);
  /// Adds a stage, or ends the one whose samples came before; FileError when it cannot be written, and the file is as
  /// it was.
  void append(const StageRecord& stage);

 private:
  std::filesystem::path file_;
  std::unique_ptr<PartialFile> partial_;  // while a stage comes in blocks
};

}  // namespace gudgeon
