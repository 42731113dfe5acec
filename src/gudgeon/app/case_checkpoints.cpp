// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is used, and what is told.
#include "gudgeon/app/case_checkpoints.h"

#include <fmt/format.h>

#include <utility>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

CaseCheckpoints::CaseCheckpoints(std::filesystem::path file, const RunRecord& header, Tell tell)
    : file_(std::move(file)), header_(header), tell_(std::move(tell)) {}

void CaseCheckpoints::read(const RunRecord& earlier) {
  try {
    saved_ = read_checkpoint(file_, header_);
    if (!saved_) return;
    const StageRecord* stage = find_stage(earlier, saved_->checkpoint.stage);
    if (stage != nullptr && stage->status == StageStatus::finished) {
      saved_.reset();  // a kill came before it was removed
    } else if (find_stage_under_way() && !std::filesystem::exists(file_)) {
      forget("the run file, with the samples that belong to its checkpoint, is gone");
    }
  } catch (const FileError& error) {
    forget(error.what());
  }
}

void CaseCheckpoints::forget(std::string_view why) {
  tell_(fmt::format("{} is run from its start: {}", saved_ ? "stage " + saved_->checkpoint.stage : "the stage", why),
        true);
  saved_.reset();
}

std::optional<StageUnderWay> CaseCheckpoints::find_stage_under_way() const {
  if (!saved_ || saved_->checkpoint.n_samples_handed_over == 0) return std::nullopt;
  const auto n_samples = static_cast<std::size_t>(saved_->checkpoint.n_samples_handed_over);
  return StageUnderWay{saved_->checkpoint.stage, n_samples, saved_->written};
}

void CaseCheckpoints::begin(const RunWriter& writer) {
  if (find_stage_under_way() && !writer.has_samples_under_way()) {
    forget("the samples that belong to its checkpoint are not in the run file");
  }
  if (!saved_) return remove_checkpoint(file_);
  tell_(fmt::format("goes on in stage {} at t = {:.9g} s", saved_->checkpoint.stage, saved_->checkpoint.time), false);
}

std::optional<Checkpoint> CaseCheckpoints::take() {
  if (!saved_) return std::nullopt;
  return std::move(std::exchange(saved_, std::nullopt)->checkpoint);
}

void CaseCheckpoints::write(Checkpoint checkpoint, RunWriter& writer) {
  try {
    const bool has_samples = checkpoint.n_samples_handed_over > 0;
    std::string written = has_samples ? writer.save_stage_under_way() : std::string{};
    write_checkpoint(file_, header_, {std::move(checkpoint), std::move(written)});
  } catch (const FileError& error) {
    if (!std::exchange(has_failed_, true)) tell_(fmt::format("goes on without checkpoints: {}", error.what()), true);
  }
}

void CaseCheckpoints::note_stage(const StageRecord& stage) {
  if (stage.status != StageStatus::stopped) remove_checkpoint(file_);
}

}  // namespace gudgeon
