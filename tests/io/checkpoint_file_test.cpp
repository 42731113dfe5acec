// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A checkpoint's file: whole, of this run, or refused.
#include "gudgeon/io/checkpoint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/state_archive.h"
#include "tests/io/scratch_directory.h"

namespace gudgeon {
namespace {

using test::ScratchDirectory;

RunRecord make_run_header() {
  RunRecord header;
  header.resolved_model = "study.cycles = 3";
  header.program_version = "1.2.3";
  return header;
}

std::string seal(std::string text) {
  return StateArchive::pack([&](StateArchive& archive) { archive.text(text); });
}

TEST(CheckpointFile, IsReadAsItWasWritten) {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "base.h5";
  const RunRecord header = make_run_header();
  EXPECT_FALSE(read_checkpoint(file, header));
  write_checkpoint(file, header, {{"wear_1", 1.5, 4096, seal(std::string("a\0b", 3))}, seal("pages")});
  const auto saved = read_checkpoint(file, header);
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->checkpoint.stage, "wear_1");
  EXPECT_EQ(saved->checkpoint.time, 1.5);
  EXPECT_EQ(saved->checkpoint.n_samples_handed_over, 4096);
  EXPECT_EQ(saved->checkpoint.state, seal(std::string("a\0b", 3)));
  EXPECT_EQ(saved->written, seal("pages"));
  remove_checkpoint(file);
  EXPECT_FALSE(read_checkpoint(file, header));
}

TEST(CheckpointFile, OfAnotherRunOrDamagedIsRefused) {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "base.h5";
  const RunRecord header = make_run_header();
  write_checkpoint(file, header, {{"wear_1", 1.5, 0, seal("state")}, ""});
  RunRecord other = header;
  other.resolved_model = "study.cycles = 4";
  EXPECT_THROW((void)read_checkpoint(file, other), FileError);
  other = header;
  other.program_version = "1.2.4";
  EXPECT_THROW((void)read_checkpoint(file, other), FileError);
  std::ofstream(find_checkpoint_file(file), std::ios::app) << "x";
  EXPECT_THROW((void)read_checkpoint(file, header), FileError);
}

// The length of the head, the head, the state, what the writer needs.
TEST(CheckpointFile, OfWhichAnyByteChangesOrLacksIsRefused) {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "base.h5";
  const RunRecord header = make_run_header();
  write_checkpoint(file, header, {{"wear_1", 1.5, 1, seal("state")}, seal("pages")});
  const auto path = find_checkpoint_file(file);
  std::ifstream in(path, std::ios::binary);
  const std::string sound{std::istreambuf_iterator<char>(in), {}};
  const auto write = [&](const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; };
  for (std::size_t k = 0; k < sound.size(); ++k) {
    std::string changed = sound;
    changed[k] = static_cast<char>(changed[k] ^ 0x40);
    write(changed);
    EXPECT_THROW((void)read_checkpoint(file, header), FileError) << k;
    write(sound.substr(0, k));
    EXPECT_THROW((void)read_checkpoint(file, header), FileError) << k;
  }
  write(sound);
  EXPECT_TRUE(read_checkpoint(file, header));
}

}  // namespace
}  // namespace gudgeon
