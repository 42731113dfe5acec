// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon draw.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(DrawCommand, DrawsToAFile) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "x.svg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "x.svg\n");
  const std::string svg = read_text(folder.path() / "x.svg");
  EXPECT_THAT(svg, StartsWith("<svg "));
  EXPECT_THAT(svg, HasSubstr(">pin</text>"));
  EXPECT_THAT(svg, HasSubstr("clearance joint"));
}

TEST(DrawCommand, DashIsStandardOutput) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, StartsWith("<svg "));
}

TEST(DrawCommand, TimeMovesIt) {
  const TemporaryFolder folder;
  const Outcome start = run_program(folder, {"draw", find_slider_crank(), "-o", "-"});
  const Outcome later = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--time", "250 ms"});
  EXPECT_THAT(later.out, HasSubstr("t = 0.25 s"));
  EXPECT_NE(start.out, later.out);
}

TEST(DrawCommand, TraceFollowsAPoint) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--trace", "crank.A"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("<polyline"));
}

TEST(DrawCommand, UnknownTracePointIsAUsageError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--trace", "crank.B"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("Did you mean 'crank."));
}

TEST(DrawCommand, TimeMustBeATime) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--time", "3 mm"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("a length"));
}

TEST(DrawCommand, ExistingFileIsKeptWithoutOverwrite) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("x.svg", "mine");
  const Outcome refused = run_program(folder, {"draw", find_slider_crank(), "-o", "x.svg"});
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_EQ(read_text(file), "mine");
  const Outcome replaced = run_program(folder, {"draw", find_slider_crank(), "-o", "x.svg", "--overwrite"});
  EXPECT_EQ(replaced.exit_code, 0);
  EXPECT_THAT(read_text(file), Not(HasSubstr("mine")));
}

TEST(DrawCommand, MissingDirectoryIsAFileError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "nowhere/x.svg"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere/x.svg"));
}

}  // namespace
}  // namespace gudgeon::test
