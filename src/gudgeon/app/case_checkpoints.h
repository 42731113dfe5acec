// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The checkpoints of one case: written while it runs, and gone on from.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "gudgeon/io/checkpoint_file.h"
#include "gudgeon/io/run_writer.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {

class CaseCheckpoints {
 public:
  /// Says a line to the user, which may tell of an error.
  using Tell = std::function<void(std::string_view line, bool is_error)>;

  /// Holds on to the header.
  CaseCheckpoints(std::filesystem::path file, const RunRecord& header, Tell tell);

  /// Takes the checkpoint that an earlier run left for the stage behind those that its file holds as finished; tells
  /// why it is not used where it is not. Before the file is changed.
  void read(const RunRecord& earlier);
  /// The stage whose samples the run file's writer has to take up, where there are any.
  [[nodiscard]] std::optional<StageUnderWay> find_stage_under_way() const;
  /// Tells where the run goes on. Without a checkpoint to go on from, one that lies there is removed.
  void begin(const RunWriter& writer);
  /// What run_study() goes on from.
  [[nodiscard]] std::optional<Checkpoint> take();

  /// Writes one, in place of the one before. Tells once when that fails: the run goes on without.
  void write(Checkpoint checkpoint, RunWriter& writer);
  /// A stage is in the run file: one that is whole needs no checkpoint any more.
  void note_stage(const StageRecord& stage);

 private:
  void forget(std::string_view why);

  std::filesystem::path file_;
  const RunRecord& header_;
  Tell tell_;
  std::optional<SavedCheckpoint> saved_;
  bool has_failed_ = false;
};

}  // namespace gudgeon
