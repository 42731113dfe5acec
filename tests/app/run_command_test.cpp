// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon run, info and export: files, cases, signals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;

/// Waits until the file is there, at most half a minute.
bool wait_for(const std::filesystem::path& file) {
  for (int i = 0; i < 3000; ++i) {
    if (std::filesystem::exists(file)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(RunCommand, WritesSummarisesAndCanBeReadAgain) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"run", find_slider_crank(), "--set", "study.cycles=1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("wear_1"));
  EXPECT_THAT(outcome.out, HasSubstr("runs/slider_crank/base.h5\n"));
  EXPECT_THAT(outcome.err, HasSubstr("base: done"));

  const Outcome info = run_program(folder, {"info", "runs/slider_crank/base.h5"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("study.cycles = 1"));
  EXPECT_THAT(info.out, HasSubstr("no_wear"));

  const Outcome csv = run_program(folder, {"export", "runs/slider_crank/base.h5", "-o", "csv"});
  EXPECT_EQ(csv.exit_code, 0) << csv.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "csv" / "no_wear_channels.csv"));
  EXPECT_EQ(run_program(folder, {"export", "runs/slider_crank/base.h5", "-o", "csv"}).exit_code, 5);
}

TEST(RunCommand, ExistingOutputIsRefusedBeforeAnyComputing) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "out");
  const auto file = folder.write("out/wide.h5", "mine");
  const Outcome outcome =
      run_program(folder, {"run", find_slider_crank(), "-o", "out", "--all-cases", "--set", "study.cycles=100000"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("out/wide.h5"));
  EXPECT_THAT(outcome.err, HasSubstr("--overwrite"));
  EXPECT_EQ(read_text(file), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out" / "base.h5"));
}

TEST(RunCommand, UnwritableDirectoryIsAFileError) {
  const TemporaryFolder folder;
  folder.write("taken", "a file, not a directory");
  const Outcome outcome = run_program(folder, {"run", find_slider_crank(), "-o", "taken/out"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("taken/out"));
}

TEST(RunCommand, UnknownCaseIsAModelErrorWithTheKnownOnes) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"run", find_slider_crank(), "--case", "wid"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("wide"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs"));
}

TEST(RunCommand, EachCaseGetsItsFile) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(
      folder, {"run", find_slider_crank(), "--all-cases", "--threads", "2", "--quiet", "--set", "study.cycles=1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "runs/slider_crank/base.h5\nruns/slider_crank/wide.h5\nruns/slider_crank/slow.h5\n");
  EXPECT_EQ(outcome.err, "");
}

TEST(RunCommand, ChannelsDoNotDependOnThreads) {
  const TemporaryFolder folder;
  for (const std::string threads : {"1", "2"}) {
    const Outcome outcome = run_program(folder, {"run", find_slider_crank(), "--all-cases", "--threads", threads, "-o",
                                                 "on_" + threads, "--quiet", "--set", "study.cycles=1"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    ASSERT_EQ(run_program(folder, {"export", "on_" + threads + "/wide.h5", "-o", "csv_" + threads}).exit_code, 0);
  }
  for (const std::string file : {"wear_1_channels.csv", "wear_1_wear.csv", "wear_1_statistics.csv"}) {
    const std::string one = read_text(folder.path() / "csv_1" / file);
    EXPECT_FALSE(one.empty()) << file;
    EXPECT_TRUE(one == read_text(folder.path() / "csv_2" / file)) << file;
  }
}

std::size_t count_lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

// 16384 samples are a block: a stage of less is written in one piece, one of more in several.
TEST(RunCommand, EverySampleIsInTheFileInHoweverManyBlocksItCame) {
  const TemporaryFolder folder;
  for (const std::string rate : {"1000", "20000"}) {
    const Outcome outcome = run_program(folder, {"run", find_slider_crank(), "--quiet", "-o", rate, "--set",
                                                 "study.cycles=1", "--set", "study.outputs_per_cycle=" + rate});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / rate / "base.h5.partial"));
    ASSERT_EQ(run_program(folder, {"export", rate + "/base.h5", "-o", "csv_" + rate}).exit_code, 0);
  }
  const auto read = [&](const std::string& file) { return read_text(folder.path() / file); };
  for (const std::string stage : {"no_wear", "wear_1"}) {
    const std::size_t n_few = count_lines(read("csv_1000/" + stage + "_channels.csv"));
    const std::size_t n_many = count_lines(read("csv_20000/" + stage + "_channels.csv"));
    EXPECT_GT(n_few, 1000U);
    EXPECT_EQ(n_many - n_few, 19000U) << stage;
    // What a run finds does not depend on what it records.
    EXPECT_TRUE(read("csv_1000/" + stage + "_wear.csv") == read("csv_20000/" + stage + "_wear.csv")) << stage;
  }
}

void expect_graceful_stop(int signal, int exit_code) {
  const TemporaryFolder folder;
  RunningProgram program(folder, {"run", find_slider_crank(), "--set", "study.cycles=100000"});
  const std::filesystem::path file = folder.path() / "runs" / "slider_crank" / "base.h5";
  ASSERT_TRUE(wait_for(file));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  program.send(signal);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, exit_code);
  EXPECT_THAT(outcome.err, HasSubstr("what was finished is kept in runs/slider_crank/base.h5"));
  const Outcome info = run_program(folder, {"info", file});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("stopped"));
}

TEST(RunCommand, InterruptLeavesAReadableFile) { expect_graceful_stop(SIGINT, 130); }

TEST(RunCommand, TerminateLeavesAReadableFile) { expect_graceful_stop(SIGTERM, 143); }

TEST(RunCommand, KillLeavesWhatWasFinishedReadable) {
  const TemporaryFolder folder;
  RunningProgram program(folder, {"run", find_slider_crank(), "--set", "study.cycles=100000"});
  const std::filesystem::path file = folder.path() / "runs" / "slider_crank" / "base.h5";
  ASSERT_TRUE(wait_for(file));
  program.send(SIGKILL);
  EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL);
  EXPECT_EQ(run_program(folder, {"info", file}).exit_code, 0);
}

/// Waits until the run file being written holds the finished stage.
bool wait_for_stage(const TemporaryFolder& folder, const std::string& run_file, const std::string& stage) {
  if (!wait_for(folder.path() / run_file)) return false;
  for (int i = 0; i < 3000; ++i) {
    if (run_program(folder, {"info", run_file}).out.find(stage + "  finished") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(RunCommand, ResumedRunHasTheSameBits) {
// A stage takes about half a second then, long enough to be interrupted.
#ifdef GUDGEON_SANITIZE
  const std::string cycles = "study.cycles=3";
#else
  const std::string cycles = "study.cycles=20";
#endif
  const TemporaryFolder folder;
  const std::vector<std::string> run{"run", find_slider_crank(), "--set", cycles, "--quiet", "-o"};
  const auto with = [&](std::initializer_list<std::string> more) {
    std::vector<std::string> arguments = run;
    arguments.insert(arguments.end(), more);
    return arguments;
  };
  ASSERT_EQ(run_program(folder, with({"whole"})).exit_code, 0);
  RunningProgram program(folder, with({"parts"}), folder.path() / "parts.txt");
  ASSERT_TRUE(wait_for_stage(folder, "parts/base.h5", "no_wear"));
  program.send(SIGINT);
  ASSERT_EQ(program.wait().exit_code, 130);
  // Without being asked to, it neither goes on nor starts anew.
  EXPECT_EQ(run_program(folder, with({"parts"})).exit_code, 5);
  ASSERT_EQ(run_program(folder, with({"parts", "--resume"})).exit_code, 0);
  for (const std::string name : {"whole", "parts"}) {
    ASSERT_EQ(run_program(folder, {"export", name + "/base.h5", "-o", "csv_" + name}).exit_code, 0);
  }
  for (const std::string file : {"no_wear_channels.csv", "wear_1_channels.csv", "wear_1_wear.csv"}) {
    EXPECT_TRUE(read_text(folder.path() / "csv_whole" / file) == read_text(folder.path() / "csv_parts" / file)) << file;
  }
  // Another model is another run.
  const Outcome other = run_program(folder, {"run", find_slider_crank(), "--quiet", "-o", "parts", "--resume"});
  EXPECT_EQ(other.exit_code, 5);
  EXPECT_THAT(other.err, HasSubstr("cannot be resumed"));
}

TEST(InfoCommand, ForeignFileIsAFileError) {
  const TemporaryFolder folder;
  folder.write("foreign.h5", "not a run file");
  const Outcome outcome = run_program(folder, {"info", "foreign.h5"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("foreign.h5"));
}

}  // namespace
}  // namespace gudgeon::test
