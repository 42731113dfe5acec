// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Two runs into one directory: the second is refused, whenever it comes, and the first does not notice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "gudgeon/io/run_reader.h"
#include "tests/app/program.h"
#include "tests/results/same_run.h"
#include "tests/verification/book/record_fault.h"

namespace gudgeon {
namespace {

using test::Outcome;
using test::run_program;
using test::RunningProgram;
using test::TemporaryFolder;
using testing::HasSubstr;

std::vector<std::string> make_arguments(const std::string& directory, std::initializer_list<std::string> more) {
  std::vector<std::string> arguments{"run",     GUDGEON_SOURCE_DIR "/tests/app/slider_crank.toml",
                                     "--set",   "study.cycles=1",
                                     "--set",   "study.wear_stages=1",
                                     "--set",   "study.compare_ideal=false",
                                     "--quiet", "-o",
                                     directory};
  arguments.insert(arguments.end(), more);
  return arguments;
}

/// The run but for the time it took.
std::string read_numbers(const std::filesystem::path& file) {
  RunRecord run = read_run(file);
  for (StageRecord& stage : run.stages) stage.solver.wall_time = 0.0;
  return test::RunBytes(run).bytes();
}

// Sanitizers make each ten times as long.
#ifdef GUDGEON_SANITIZE
constexpr int kTrials = 4;
#else
constexpr int kTrials = 50;
#endif

constexpr const char* kRefused =
    "/base.h5: another run is writing it; wait for its end or give another directory with -o\n";

/// How the second ended, started when the first has run that long since its lock was there. The first is halted
/// meanwhile, so that how long the second takes to start is of no account.
int run_second(const TemporaryFolder& folder, const std::string& directory, std::chrono::duration<double> after,
               const std::string& how) {
  RunningProgram first(folder, make_arguments(directory, {"--overwrite"}), folder.path() / "first.out",
                       folder.path() / "first.err");
  const std::filesystem::path lock = folder.path() / directory / ".gudgeon.lock";
  while (!std::filesystem::exists(lock) && !first.has_ended()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(after);
  first.send(SIGSTOP);
  const Outcome second = run_program(folder, make_arguments(directory, {how}));
  first.send(SIGCONT);
  const Outcome outcome = first.wait();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  if (second.exit_code != 0) {  // or the first had ended
    EXPECT_EQ(second.exit_code, 5) << second.err;
    EXPECT_THAT(second.err, HasSubstr(kRefused));
    EXPECT_EQ(std::ranges::count(second.err, '\n'), 1);
  }
  EXPECT_FALSE(std::filesystem::exists(lock));
  return second.exit_code;
}

TEST(RunLock, OfTwoRunsIntoOneDirectoryOneIsRefused) {
  const TemporaryFolder folder;
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program(folder, make_arguments("right", {})).exit_code, 0);
  const auto whole = std::chrono::steady_clock::now() - start;
  const std::string right = read_numbers(folder.path() / "right" / "base.h5");
  int n_refused = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::string directory = "runs_" + std::to_string(trial);
    const std::string how = trial % 2 == 0 ? "--overwrite" : "--resume";
    if (run_second(folder, directory, whole * trial / kTrials, how) == 5) ++n_refused;
    ASSERT_TRUE(read_numbers(folder.path() / directory / "base.h5") == right) << trial;
  }
  EXPECT_GT(n_refused, kTrials / 10);
  book::record_fault({"two runs into one directory, at different delays", kTrials, HasFailure() ? 1 : 0, "results"});
}

// Either may be first; then the other is the one refused, or comes when the first has ended.
TEST(RunLock, OfTwoStartedAtOnceOneIsWhole) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, make_arguments("right", {})).exit_code, 0);
  const std::string right = read_numbers(folder.path() / "right" / "base.h5");
  for (int trial = 0; trial < kTrials / 4; ++trial) {
    const std::string directory = "runs_" + std::to_string(trial);
    RunningProgram first(folder, make_arguments(directory, {"--overwrite"}), folder.path() / "first.out",
                         folder.path() / "first.err");
    const Outcome second = run_program(folder, make_arguments(directory, {"--overwrite"}));
    const Outcome outcome = first.wait();
    ASSERT_THAT((std::vector<int>{outcome.exit_code, second.exit_code}),
                testing::AnyOf(testing::ElementsAre(0, 5), testing::ElementsAre(5, 0), testing::ElementsAre(0, 0)))
        << trial << ": " << outcome.err << second.err;
    ASSERT_TRUE(read_numbers(folder.path() / directory / "base.h5") == right) << trial;
  }
}

TEST(RunLock, CasesOfOneDirectoryRunSideBySide) {
  const TemporaryFolder folder;
  RunningProgram wide(folder, make_arguments("runs", {"--case", "wide"}), folder.path() / "wide.out",
                      folder.path() / "wide.err");
  const Outcome slow = run_program(folder, make_arguments("runs", {"--case", "slow"}));
  EXPECT_EQ(slow.exit_code, 0) << slow.err;
  EXPECT_EQ(wide.wait().exit_code, 0);
  EXPECT_EQ(read_run(folder.path() / "runs" / "wide.h5").stages.size(), 2u);
  EXPECT_EQ(read_run(folder.path() / "runs" / "slow.h5").stages.size(), 2u);
}

// A kill leaves the lock file; it holds nobody.
TEST(RunLock, WhatAKilledRunLeavesHoldsNobody) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "runs");
  folder.write("runs/.gudgeon.lock", "");
  EXPECT_EQ(run_program(folder, make_arguments("runs", {})).exit_code, 0);
}

TEST(RunLock, WhatIsNoFileIsNamed) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "runs" / ".gudgeon.lock");
  const Outcome outcome = run_program(folder, make_arguments("runs", {}));
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err,
              HasSubstr(".gudgeon.lock: cannot be locked: what is there is no regular file; move it away"));
}

TEST(InfoCommand, VerifyNamesWhatIsDamaged) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder, make_arguments("runs", {})).exit_code, 0);
  const std::filesystem::path file = folder.path() / "runs" / "base.h5";
  const Outcome sound = run_program(folder, {"info", "--verify", file});
  EXPECT_EQ(sound.exit_code, 0) << sound.err;
  EXPECT_THAT(sound.out, HasSubstr("sound: 2 stages"));
  std::string bytes;
  {
    std::ifstream in(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
  // Within the samples, which are most of the file.
  for (const double place : {0.3, 0.5, 0.7}) {
    const auto at = static_cast<std::size_t>(place * static_cast<double>(bytes.size()));
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
  }
  folder.write("runs/base.h5", bytes);
  const Outcome damaged = run_program(folder, {"info", "--verify", file});
  EXPECT_EQ(damaged.exit_code, 5);
  EXPECT_THAT(damaged.err, HasSubstr("base.h5: is damaged"));
  EXPECT_THAT(damaged.err, HasSubstr("/stages/"));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"export", file.string(), "-o", "csv"}, make_arguments("runs", {"--resume"})}) {
    const Outcome outcome = run_program(folder, command);
    EXPECT_EQ(outcome.exit_code, 5) << command[0];
    EXPECT_THAT(outcome.err, HasSubstr("base.h5")) << command[0];
  }
}

}  // namespace
}  // namespace gudgeon
