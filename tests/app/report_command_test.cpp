// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon report and gudgeon plot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A short run of the slider-crank in runs/.
void run_short(const TemporaryFolder& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"run", find_slider_crank(), "-o", "runs", "--quiet", "--set", "study.cycles=1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run_program(folder, arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(ReportCommand, WritesOneFileThatNeedsNothingElse) {
  const TemporaryFolder folder;
  run_short(folder);
  const Outcome outcome = run_program(folder, {"report", "runs"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "runs/report.html\n");
  const std::string page = read_text(folder.path() / "runs/report.html");
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  for (const char* foreign : {"src=\"http", "href=\"http", "url(http", "@import", "fetch(", "XMLHttpRequest"}) {
    EXPECT_THAT(page, Not(HasSubstr(foreign)));
  }
}

TEST(ReportCommand, SameRunGivesTheSamePage) {
  const TemporaryFolder folder;
  run_short(folder);
  run_program(folder, {"report", "runs", "-o", "a.html"});
  run_program(folder, {"report", "runs/base.h5", "-o", "b.html"});
  EXPECT_EQ(read_text(folder.path() / "a.html"), read_text(folder.path() / "b.html"));
}

TEST(ReportCommand, ExistingFileIsKeptWithoutOverwrite) {
  const TemporaryFolder folder;
  run_short(folder);
  folder.write("runs/report.html", "mine");
  EXPECT_EQ(run_program(folder, {"report", "runs"}).exit_code, 5);
  EXPECT_EQ(read_text(folder.path() / "runs/report.html"), "mine");
  EXPECT_EQ(run_program(folder, {"report", "runs", "--overwrite"}).exit_code, 0);
}

TEST(ReportCommand, DirectoryWithoutRunsIsOneClearLine) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"report", "."});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("has no run file"));
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
}

TEST(ReportCommand, BrokenFileIsNamedAndTheRestShown) {
  const TemporaryFolder folder;
  run_short(folder);
  folder.write("runs/broken.h5", "not HDF5");
  const Outcome outcome = run_program(folder, {"report", "runs"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("broken.h5"));
  EXPECT_THAT(read_text(folder.path() / "runs/report.html"), HasSubstr("Not in this report: runs/broken.h5"));
  EXPECT_EQ(run_program(folder, {"report", "runs/broken.h5"}).exit_code, 5);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs/broken.html"));
}

TEST(ReportCommand, SameCaseTwiceIsShownOnce) {
  const TemporaryFolder folder;
  run_short(folder);
  std::filesystem::copy_file(folder.path() / "runs/base.h5", folder.path() / "runs/copy.h5");
  const Outcome outcome = run_program(folder, {"report", "runs"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("copy.h5: holds case 'base' as runs/base.h5 does"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs/report.html"));
}

TEST(ReportCommand, RunWritesItToo) {
  const TemporaryFolder folder;
  run_short(folder, {"--report"});
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "runs/report.html"));
}

TEST(PlotCommand, WritesTheFiguresAskedFor) {
  const TemporaryFolder folder;
  run_short(folder);
  const Outcome list = run_program(folder, {"plot", "runs", "--list"});
  EXPECT_THAT(list.out, HasSubstr("base.pin.orbit\n"));
  const Outcome one = run_program(folder, {"plot", "runs", "-o", "figures", "--figure", "pin.orbit"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out, "figures/base.pin.orbit.svg\n");
  const std::string svg = read_text(folder.path() / "figures/base.pin.orbit.svg");
  EXPECT_THAT(svg, StartsWith("<svg "));
  EXPECT_THAT(svg, HasSubstr("clearance circle"));
}

TEST(PlotCommand, UnknownFigureIsAUsageError) {
  const TemporaryFolder folder;
  run_short(folder);
  const Outcome outcome = run_program(folder, {"plot", "runs", "-o", "figures", "--figure", "base.pin.orbt"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("Did you mean 'base.pin.orbit'?"));
  EXPECT_EQ(run_program(folder, {"plot", "runs"}).exit_code, 2);
}

TEST(PlotCommand, MissingConverterIsOneClearLine) {
  const TemporaryFolder folder;
  run_short(folder);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const Outcome outcome = run_program(folder, {"plot", "runs", "-o", "f", "--figure", "pin.orbit", "--format", "png"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("librsvg2-bin"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "f/base.pin.orbit.svg"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "f/base.pin.orbit.png"));
}

}  // namespace
}  // namespace gudgeon::test
