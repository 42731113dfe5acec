// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Root of a run file; stages are added to a copy on disk, which then replaces the file as a whole.
#include "gudgeon/io/run_writer.h"

#include <fmt/format.h>

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/run_tables.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/io/stage_writer.h"

namespace gudgeon {

namespace {

void write_header(const Hdf5Handle& root, const RunRecord& header) {
  write_text_attribute(root, "format", kRunFormat);
  write_count_attribute(root, "format_version", kRunFormatVersion);
  write_text_attribute(root, "program_version", header.program_version);
  write_text_attribute(root, "model_file", header.model_file);
  write_text_attribute(root, "case_name", header.case_name);
  write_text(root, "model_text", header.model_text);
  write_text(root, "explained", header.explained);
  std::vector<OverrideRow> overrides;
  for (const auto& [path, text] : header.overrides) overrides.push_back({path.c_str(), text.c_str()});
  write_table(root, "overrides", kOverrideShape, overrides.data(), overrides.size());
  make_group(root, "stages");
}

/// A failed stage is found without reading all of them.
void write_failure(const Hdf5Handle& root, const StageRecord& stage) {
  if (has_link(root, "failure")) return;  // the first one is the cause
  const Hdf5Handle failure = make_group(root, "failure");
  write_text_attribute(failure, "stage_name", stage.name);
  write_text_attribute(failure, "message", stage.message);
  write_real_attribute(failure, "time", stage.end_time);
  write_text_attribute(failure, "time.unit", "s");
  make_soft_link(failure, "stage", "/stages/" + stage.name);
}

void copy_stages(const std::filesystem::path& file, std::span<const std::string> names, const Hdf5Handle& root) {
  if (names.empty()) return;
  try {
    const Hdf5Handle from = open_group(open_root(open_file(file)), "stages");
    const Hdf5Handle to = open_group(root, "stages");
    for (const std::string& name : names) copy_group(from, name, to);
  } catch (const FileError& error) {
    throw FileError(
        fmt::format("{}: its stages cannot be taken over: {}; it is as it was", file.string(), error.what()));
  }
}

/// Changes the stages of the partial file, and tells of which stage the trouble is.
void change_stages(const PartialFile& partial, std::string_view stage,
                   const std::function<void(const Hdf5Handle& root, const Hdf5Handle& stages)>& change) {
  const Hdf5Session session;
  change_inside(partial, [&](const Hdf5Handle& root) {
    try {
      change(root, open_group(root, "stages"));
    } catch (const FileError& error) {
      throw FileError(fmt::format("{}: stage '{}' cannot be added: {}; earlier stages are kept",
                                  partial.file().string(), stage, error.what()));
    }
  });
}

std::unique_ptr<PartialFile> copy_to_partial(const std::filesystem::path& file) {
  auto partial = std::make_unique<PartialFile>(file);
  partial->write_old_version();
  return partial;
}

}  // namespace

RunWriter::RunWriter(std::filesystem::path file, const RunRecord& header, bool overwrite,
                     std::span<const std::string> kept)
    : file_(std::move(file)) {
  check_target(file_, overwrite);
  PartialFile partial(file_);
  {
    const Hdf5Session session;
    change_inside(partial, [&](const Hdf5Handle& root) {
      write_header(root, header);
      copy_stages(file_, kept, root);
    });
  }
  partial.put_in_place();
}

void RunWriter::append(const SampleBlock& block) {
  // Held here while it changes: an error takes it away.
  std::unique_ptr<PartialFile> partial = std::move(partial_);
  const bool is_first = partial == nullptr;
  if (is_first) partial = copy_to_partial(file_);
  change_stages(*partial, block.stage, [&](const Hdf5Handle&, const Hdf5Handle& stages) {
    is_first ? begin_stage(stages, block) : extend_stage(stages, block);
  });
  partial_ = std::move(partial);
}

void RunWriter::append(const StageRecord& stage) {
  std::unique_ptr<PartialFile> partial = std::move(partial_);
  const bool is_whole = partial == nullptr;
  if (is_whole) partial = copy_to_partial(file_);
  change_stages(*partial, stage.name, [&](const Hdf5Handle& root, const Hdf5Handle& stages) {
    is_whole ? write_stage(stages, stage) : end_stage(stages, stage);
    if (stage.status == StageStatus::failed) write_failure(root, stage);
  });
  partial->put_in_place();
}

}  // namespace gudgeon
