// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A checkpoint's file: whole, of this run, or refused.
#include "gudgeon/io/checkpoint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "gudgeon/base/diagnostics.h"
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

TEST(CheckpointFile, IsReadAsItWasWritten) {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "base.h5";
  const RunRecord header = make_run_header();
  EXPECT_FALSE(read_checkpoint(file, header));
  write_checkpoint(file, header, {{"wear_1", 1.5, 4096, std::string("a\0b", 3)}, "pages"});
  const auto saved = read_checkpoint(file, header);
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->checkpoint.stage, "wear_1");
  EXPECT_EQ(saved->checkpoint.time, 1.5);
  EXPECT_EQ(saved->checkpoint.n_samples_handed_over, 4096);
  EXPECT_EQ(saved->checkpoint.state, std::string("a\0b", 3));
  EXPECT_EQ(saved->written, "pages");
  remove_checkpoint(file);
  EXPECT_FALSE(read_checkpoint(file, header));
}

TEST(CheckpointFile, OfAnotherRunOrDamagedIsRefused) {
  const ScratchDirectory scratch;
  const auto file = scratch.path() / "base.h5";
  const RunRecord header = make_run_header();
  write_checkpoint(file, header, {{"wear_1", 1.5, 0, "state"}, ""});
  RunRecord other = header;
  other.resolved_model = "study.cycles = 4";
  EXPECT_THROW((void)read_checkpoint(file, other), FileError);
  other = header;
  other.program_version = "1.2.4";
  EXPECT_THROW((void)read_checkpoint(file, other), FileError);
  std::ofstream(find_checkpoint_file(file), std::ios::app) << "x";
  EXPECT_THROW((void)read_checkpoint(file, header), FileError);
}

}  // namespace
}  // namespace gudgeon
