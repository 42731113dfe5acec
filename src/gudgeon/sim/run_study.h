// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The stages of one case, one after the other: ideal, no wear, first wear, second wear …
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string_view>

#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"
#include "gudgeon/results/checkpoint.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/results/sample_block.h"
#include "gudgeon/sim/stage_recorder.h"

namespace gudgeon {

/// How far a case has come.
struct Progress {
  std::string_view stage;  ///< name of the stage under way
  int stage_index = 0;
  int n_stages = 1;
  double fraction = 0.0;  ///< of the stage's time

  /// Of the whole case, all stages counted alike.
  [[nodiscard]] double share() const { return (stage_index + fraction) / n_stages; }
};

/// What a caller may hang into a run. Callbacks come from the thread that runs the case.
struct RunHooks {
  std::stop_token stop;                                    ///< stops at the next accepted step
  std::function<void(const Progress&)> progress;           ///< about a hundred times a stage
  std::function<void(const StageRecord&)> stage_finished;  ///< also for a stage that stopped or failed

  /// Takes the samples of a stage block by block, in order; those after the last full block come with stage_finished,
  /// and no record that stays in memory has any. Without it, records keep them all.
  std::function<void(const SampleBlock&)> samples;
  std::size_t samples_per_block = kSamplesPerBlock;  ///< or fewer, where a sample is large

  /// Takes the stage under way, when `checkpoint_wanted` is set from outside, which clears it, and where the stage is
  /// stopped; after the samples that were handed over before. A stage by the stiff integrator gives one when it next
  /// can, and none where it is stopped. That one is taken changes no bit of the results.
  std::function<void(Checkpoint)> checkpoint;
  std::atomic<bool>* checkpoint_wanted = nullptr;
};

/// Runs every stage of the study. Each stage is handed to hooks.stage_finished as soon as it ends and is also
/// returned, without its samples when hooks.samples took them. A stage that stops or fails ends the run; its record
/// says when and why. Stages that an earlier run of the same study has finished are taken over instead of run: a stage
/// depends on those before it only by their wear. The stage of the checkpoint goes on from there; samples that it had
/// handed over are not handed over again. Throws ModelError when the mechanism cannot be assembled, and FileError when
/// the checkpoint is not of this study.
std::vector<StageRecord> run_study(const Mechanism& mechanism, const Study& study, const RunHooks& hooks = {},
                                   std::vector<StageRecord> finished = {},
                                   std::optional<Checkpoint> checkpoint = std::nullopt);

}  // namespace gudgeon
