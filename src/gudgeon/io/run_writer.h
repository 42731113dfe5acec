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

/// A stage that was not ended: what a writer needs to go on with it.
struct StageUnderWay {
  std::string stage;
  std::size_t n_samples = 0;  ///< that were appended in blocks
  std::string saved;          ///< from RunWriter::save_stage_under_way()
};

/// Writes a run file stage by stage, each once. The file on disk is complete and readable at any moment: what is added
/// comes behind its end, and is part of it once its stage is whole, so a kill or a full disk never spoils what was
/// finished. Several writers may work on several files from several threads.
class RunWriter {
 public:
  /// Creates the file with everything but the header's own stages. FileError when it exists and may not be replaced, or
  /// cannot be written. With stages to keep, or one under way, goes on with the file that is there: its other stages
  /// are removed.
  RunWriter(std::filesystem::path file, const RunRecord& header, bool overwrite, std::span<const std::string> kept = {},
            const StageUnderWay* under_way = nullptr);

  /// Whether the samples of the stage under way are there, so that those after them are to come next; otherwise it
  /// begins anew.
  [[nodiscard]] bool has_samples_under_way() const { return has_samples_under_way_; }
  /// What StageUnderWay::saved holds; its samples are on the disk when it returns, and nothing later changes them
  /// before the stage is ended. FileError when they cannot be brought there.
  std::string save_stage_under_way();

  /// Adds samples of a stage under way, so that they need not stay in memory; FileError when they cannot be written:
  /// the file is as it was, and the stage begins anew.
  void append(const SampleBlock& block);
  /// Adds a stage, or ends the one whose samples came before; FileError when it cannot be written, and the file is as
  /// it was.
  void append(const StageRecord& stage);

 private:
  void open();
  void keep(std::span<const std::string> stages);
  void go_on(std::span<const std::string> stages, const StageUnderWay* under_way);
  [[nodiscard]] bool take_up(const StageUnderWay& under_way);
  void renew(const RunRecord& header, std::span<const std::string> stages);
  void change(std::string_view stage,
              const std::function<void(const Hdf5Handle& root, const Hdf5Handle& stages)>& change);

  std::filesystem::path file_;
  std::unique_ptr<GrowingFile> growing_;  // changed under a session alone; what is not committed goes with it
  bool has_samples_under_way_ = false;
};

}  // namespace gudgeon
