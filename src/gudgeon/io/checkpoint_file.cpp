// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What it belongs to, then the checkpoint, in sealed bytes.
#include "gudgeon/io/checkpoint_file.h"

#include <fmt/format.h>

#include <fstream>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/state_archive.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon {

namespace {

void transfer(StateArchive& archive, SavedCheckpoint& saved) {
  archive.text(saved.checkpoint.stage);
  archive(saved.checkpoint.time, saved.checkpoint.n_samples_handed_over);
  archive.text(saved.checkpoint.state);
  archive.text(saved.written);
}

}  // namespace

std::filesystem::path find_checkpoint_file(const std::filesystem::path& run_file) {
  return run_file.string() + ".checkpoint";
}

void write_checkpoint(const std::filesystem::path& run_file, const RunRecord& header, const SavedCheckpoint& saved) {
  StateArchive archive;
  archive.require_text(header.program_version);
  archive.require_text(header.resolved_model);
  SavedCheckpoint copy = saved;
  transfer(archive, copy);
  write_whole(find_checkpoint_file(run_file), archive.seal());
}

std::optional<SavedCheckpoint> read_checkpoint(const std::filesystem::path& run_file, const RunRecord& header) {
  const std::filesystem::path file = find_checkpoint_file(run_file);
  std::error_code failure;
  if (!std::filesystem::exists(std::filesystem::symlink_status(file, failure))) return std::nullopt;
  check_source(file);
  constexpr std::uintmax_t kLargest = 1U << 30U;  // [bytes] ten times a block of samples and all surfaces
  const std::uintmax_t size = std::filesystem::file_size(file);
  if (size > kLargest) throw FileError(fmt::format("{}: is larger than any checkpoint", file.string()));
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    StateArchive archive(bytes);
    archive.require_text(header.program_version);
    archive.require_text(header.resolved_model);
    SavedCheckpoint saved;
    transfer(archive, saved);
    archive.expect_end();
    return saved;
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void remove_checkpoint(const std::filesystem::path& run_file) {
  std::error_code failure;
  std::filesystem::remove(find_checkpoint_file(run_file), failure);
}

}  // namespace gudgeon
