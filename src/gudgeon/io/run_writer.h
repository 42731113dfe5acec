// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a run to HDF5, stage by stage. The layout is described in docs/guide/run_file.md.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "gudgeon/io/growing_file.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/results/sample_block.h"

namespace gudgeon {

/// Writes a run file stage by stage, each once. The file on disk is complete and readable at any moment: what is added
/// comes behind its end, and is part of it once its stage is whole, so a kill or a full disk never spoils what was
/// finished. Several writers may work on several files from several threads.
class RunWriter {
 public:
  /// Creates the file with everything but the header's own stages. FileError when it exists and may not be replaced, or
  /// cannot be written. With stages to keep, goes on with the file that is there: its other stages are removed.
  RunWriter(std::filesystem::path file, const RunRecord& header, bool overwrite,
            std::span<const std::string> kept = {});
  RunWriter(const RunWriter&) = delete;
  RunWriter& operator=(const RunWriter&) = delete;
  ~RunWriter();  // a stage under way is not in the file

  /// Adds samples of a stage under way, so that they need not stay in memory; FileError when they cannot be written:
  /// the file is as it was, and the stage begins anew.
  void append(const SampleBlock& block);
  /// Adds a stage, or ends the one whose samples came before; FileError when it cannot be written, and the file is as
  /// it was.
  void append(const StageRecord& stage);

 private:
  void open();
  void keep(std::span<const std::string> stages);
  void renew(const RunRecord& header, std::span<const std::string> stages);
  void change(std::string_view stage,
              const std::function<void(const Hdf5Handle& root, const Hdf5Handle& stages)>& change);

  std::filesystem::path file_;
  std::unique_ptr<GrowingFile> growing_;  // touched under a session alone
};

}  // namespace gudgeon
