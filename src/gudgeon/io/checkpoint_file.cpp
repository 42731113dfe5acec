// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The length of a head that says what it belongs to, the head, then what may be long, each in sealed bytes.
#include "gudgeon/io/checkpoint_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/state_archive.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon {

namespace {

/// What stands before the state and what the writer needs, which are sealed themselves.
struct Head {
  std::uint64_t n_state = 0;    // [bytes]
  std::uint64_t n_written = 0;  // [bytes]
};

void transfer(StateArchive& archive, const RunRecord& header, Checkpoint& checkpoint, Head& head) {
  archive.require_text(header.program_version);
  archive.require_text(header.resolved_model);
  archive.text(checkpoint.stage);
  archive(checkpoint.time, checkpoint.n_samples_handed_over, head.n_state, head.n_written);
}

/// Takes so many bytes from the front, sealed ones where there are any.
std::string take(std::string_view& bytes, std::uint64_t n) {
  if (n > bytes.size()) StateArchive::refuse();
  std::string taken(bytes.substr(0, n));
  bytes.remove_prefix(n);
  if (n > 0) StateArchive{taken};  // throws when they are damaged
  return taken;
}

SavedCheckpoint unpack(std::string_view bytes, const RunRecord& header) {
  std::uint64_t n_head = 0;
  if (bytes.size() < sizeof n_head) StateArchive::refuse();
  std::memcpy(&n_head, bytes.data(), sizeof n_head);
  bytes.remove_prefix(sizeof n_head);
  if (n_head == 0) StateArchive::refuse();
  const std::string sealed = take(bytes, n_head);
  StateArchive archive(sealed);
  SavedCheckpoint saved;
  Head head;
  transfer(archive, header, saved.checkpoint, head);
  archive.expect_end();
  saved.checkpoint.state = take(bytes, head.n_state);
  saved.written = take(bytes, head.n_written);
  if (!bytes.empty()) StateArchive::refuse();
  return saved;
}

}  // namespace

std::filesystem::path find_checkpoint_file(const std::filesystem::path& run_file) {
  return run_file.string() + ".checkpoint";
}

void write_checkpoint(const std::filesystem::path& run_file, const RunRecord& header, const SavedCheckpoint& saved) {
  Head head{saved.checkpoint.state.size(), saved.written.size()};
  Checkpoint without_state{saved.checkpoint.stage, saved.checkpoint.time, saved.checkpoint.n_samples_handed_over, {}};
  const std::string sealed =
      StateArchive::pack([&](StateArchive& archive) { transfer(archive, header, without_state, head); });
  const std::uint64_t n_head = sealed.size();
  PartialFile partial(find_checkpoint_file(run_file));
  partial.write(std::as_bytes(std::span(&n_head, 1)));
  for (const std::string* part : {&sealed, &saved.checkpoint.state, &saved.written}) {
    partial.write(std::as_bytes(std::span(*part)));
  }
  partial.put_in_place();
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
    return unpack(bytes, header);
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void remove_checkpoint(const std::filesystem::path& run_file) {
  std::error_code failure;
  std::filesystem::remove(find_checkpoint_file(run_file), failure);
}

}  // namespace gudgeon
