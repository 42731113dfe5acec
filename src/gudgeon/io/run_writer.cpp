// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Root of a run file; stages are added to an image in memory, which then replaces the file as a whole.
#include "gudgeon/io/run_writer.h"

#include <fmt/format.h>

#include <cstddef>
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

void write_header(const Hdf5Handle& file, const RunRecord& header) {
  const Hdf5Handle root = open_root(file);
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

void add_stage(const Hdf5Handle& file, const StageRecord& stage) {
  const Hdf5Handle root = open_root(file);
  const Hdf5Handle stages = open_group(root, "stages");
  if (has_link(stages, stage.name)) throw FileError("a stage of that name is there already");
  write_stage(stages, stage, static_cast<std::int64_t>(find_children(stages).size()));
  if (stage.status == StageStatus::failed) write_failure(root, stage);
}

Hdf5Image make_first_image(const RunRecord& header, std::span<const StageRecord> stages) {
  const Hdf5Session session;
  Hdf5Image image;
  write_header(image.file(), header);
  for (const StageRecord& stage : stages) add_stage(image.file(), stage);
  image.finish();
  return image;
}

/// The file's bytes with a stage more.
Hdf5Image make_next_image(const std::vector<std::byte>& old_bytes, const StageRecord& stage) {
  const Hdf5Session session;
  Hdf5Image image(old_bytes);
  add_stage(image.file(), stage);
  image.finish();
  return image;
}

/// The same, with the file's path in what goes wrong.
Hdf5Image make_next_image(const std::filesystem::path& file, const StageRecord& stage) {
  const std::vector<std::byte> old_bytes = read_whole(file);
  try {
    return make_next_image(old_bytes, stage);
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}: stage '{}' cannot be added: {}; earlier stages are kept", file.string(),
                                stage.name, error.what()));
  }
}

}  // namespace

RunWriter::RunWriter(std::filesystem::path file, const RunRecord& header, bool overwrite,
                     std::span<const StageRecord> stages)
    : file_(std::move(file)) {
  check_target(file_, overwrite);
  write_whole(file_, make_first_image(header, stages).bytes());
}

void RunWriter::append(const StageRecord& stage) { write_whole(file_, make_next_image(file_, stage).bytes()); }

}  // namespace gudgeon
