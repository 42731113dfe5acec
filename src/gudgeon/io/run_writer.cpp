// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Root of a run file; stages are added to the file in place, each at once.
#include "gudgeon/io/run_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/stable_hash.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/page_journal.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_tables.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/io/stage_writer.h"

namespace gudgeon {

namespace {

constexpr unsigned kStagesAtFirst = 40;  // that the group's own header has room for from the start

void write_header(const Hdf5Handle& root, const RunRecord& header) {
  write_text_attribute(root, "format", kRunFormat);
  write_count_attribute(root, "format_version", kRunFormatVersion);
  write_text_attribute(root, "program_version", header.program_version);
  write_text_attribute(root, "model_file", header.model_file);
  write_text_attribute(root, "case_name", header.case_name);
  // In the file's first page, by which a journal knows the file that it belongs to.
  write_text_attribute(root, "model_key", fmt::format("{:016x}", find_stable_hash(header.resolved_model)));
  // What changes with every stage comes first: it then changes with the file's first page.
  make_group(root, "stages", kStagesAtFirst, 8);
  write_text(root, "model_text", header.model_text);
  write_text(root, "resolved_model", header.resolved_model);
  std::vector<OverrideRow> overrides;
  for (const auto& [path, text] : header.overrides) overrides.push_back({path.c_str(), text.c_str()});
  write_table(root, "overrides", kOverrideShape, overrides.data(), overrides.size());
}

/// A failed stage is found without reading all of them.
void write_failure(const Hdf5Handle& root, const StageRecord& stage) {
  if (has_link(root, "failure")) return;  // the first one is the cause
  const Hdf5Handle failure = make_group(root, "failure");
  write_text(failure, "stage_name", stage.name);
  write_text(failure, "message", stage.message);
  write_real(failure, "time", stage.end_time, "s");
  make_soft_link(failure, "stage", "/stages/" + stage.name);
}

/// Of the file that is replaced; before that is gone, what stands in the way of the next journal is told.
void remove_journal(const std::filesystem::path& file) {
  std::error_code failure;
  const std::filesystem::path journal = find_journal(file);
  const std::filesystem::file_status there = std::filesystem::symlink_status(journal, failure);
  if (!std::filesystem::exists(there)) return;
  if (!std::filesystem::is_regular_file(there)) {
    throw FileError(
        fmt::format("{}: is no regular file where the run's journal belongs; move it away", journal.string()));
  }
  if (!std::filesystem::remove(journal, failure)) {
    throw FileError(fmt::format("{}: cannot be removed: {}", journal.string(), failure.message()));
  }
}

void make_file(const std::filesystem::path& file, const RunRecord& header) {
  PartialFile partial(file);
  {
    const Hdf5Session session;
    change_inside(partial, [&](const Hdf5Handle& root) { write_header(root, header); });
  }
  remove_journal(file);
  partial.put_in_place();
}

/// Whether there is anything but the stages that are kept; FileError when one of those is missing.
bool has_others(const Hdf5Handle& root, std::span<const std::string> kept) {
  const Hdf5Handle stages = open_group(root, "stages");
  for (const std::string& name : kept) require_link(stages, name, "stage");
  return has_link(root, "failure") || find_members(stages).size() != kept.size();
}

void remove_others(const Hdf5Handle& root, std::span<const std::string> kept) {
  const Hdf5Handle stages = open_group(root, "stages");
  for (const std::string& name : find_members(stages)) {
    if (std::ranges::find(kept, name) == kept.end()) remove_link(stages, name);
  }
  if (has_link(root, "failure")) remove_link(root, "failure");  // a stage that failed is not kept
}

bool is_of_this_format(const std::filesystem::path& file) {
  const Hdf5Session session;
  return read_count_attribute(Hdf5Source(file).root(), "format_version") == kRunFormatVersion;
}

}  // namespace

RunWriter::RunWriter(std::filesystem::path file, const RunRecord& header, bool overwrite,
                     std::span<const std::string> kept, const StageUnderWay* under_way)
    : file_(std::move(file)) {
  check_target(file_, overwrite);
  if (kept.empty() && under_way == nullptr) {
    make_file(file_, header);
    open();
  } else if (is_of_this_format(file_)) {
    open();
    go_on(kept, under_way);
  } else {
    renew(header, kept);
  }
}

void RunWriter::go_on(std::span<const std::string> stages, const StageUnderWay* under_way) {
  has_samples_under_way_ = under_way != nullptr && under_way->n_samples > 0 && take_up(*under_way);
  if (!has_samples_under_way_) keep(stages);
}

// After a kill they lie behind the file's end. A stage that was stopped is in the file with all that had come by then.
bool RunWriter::take_up(const StageUnderWay& under_way) {
  const Hdf5Session session;
  if (growing_->restore_changes(under_way.saved)) return true;
  try {
    const Hdf5Source source(file_);
    if (!has_link(open_group(source.root(), "stages"), under_way.stage)) return false;
    growing_->change([&](const Hdf5Handle& root) {
      reopen_stage(open_group(root, "stages"), under_way.stage, under_way.n_samples);
    });
    return true;
  } catch (const FileError&) {
    return false;  // it has other samples: the stage begins anew
  }
}

std::string RunWriter::save_stage_under_way() {
  const Hdf5Session session;
  return growing_->save_changes();
}

void RunWriter::open() {
  const Hdf5Session session;
  growing_ = std::make_unique<GrowingFile>(file_);
}

void RunWriter::keep(std::span<const std::string> stages) {
  const Hdf5Session session;
  try {
    if (!has_others(Hdf5Source(file_).root(), stages)) return;
    growing_->change([&](const Hdf5Handle& root) { remove_others(root, stages); });
  } catch (const FileError& error) {
    throw FileError(
        fmt::format("{}: its stages cannot be taken over: {}; it is as it was", file_.string(), error.what()));
  }
  growing_->commit();
}

void RunWriter::renew(const RunRecord& header, std::span<const std::string> stages) {
  const RunRecord old = read_run(file_);
  make_file(file_, header);
  open();
  for (const std::string& name : stages) append(*find_stage(old, name));
}

void RunWriter::change(std::string_view stage,
                       const std::function<void(const Hdf5Handle& root, const Hdf5Handle& stages)>& change) {
  growing_->change([&](const Hdf5Handle& root) {
    try {
      change(root, open_group(root, "stages"));
    } catch (const FileError& error) {
      throw FileError(fmt::format("{}: stage '{}' cannot be added: {}; earlier stages are kept", file_.string(), stage,
                                  error.what()));
    }
  });
}

void RunWriter::append(const SampleBlock& block) {
  const Hdf5Session session;
  const bool is_first = !growing_->is_changed();
  change(block.stage, [&](const Hdf5Handle&, const Hdf5Handle& stages) {
    is_first ? begin_stage(stages, block) : extend_stage(stages, block);
  });
}

void RunWriter::append(const StageRecord& stage) {
  const Hdf5Session session;
  const bool is_whole = !growing_->is_changed();
  change(stage.name, [&](const Hdf5Handle& root, const Hdf5Handle& stages) {
    is_whole ? write_stage(stages, stage) : end_stage(stages, stage);
    if (stage.status == StageStatus::failed) write_failure(root, stage);
  });
  growing_->commit();
}

}  // namespace gudgeon
