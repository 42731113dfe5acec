// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs that are stopped or killed within a stage, and go on there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/app/program.h"
#include "tests/verification/book/record_fault.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using namespace std::chrono_literals;

// Sanitizers make each ten times as long.
#ifdef GUDGEON_SANITIZE
constexpr int kCycles = 2;
constexpr int kManyCycles = 2;
#else
constexpr int kCycles = 12;
constexpr int kManyCycles = 20;
#endif

class CheckpointRun : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> arguments(const std::string& directory,
                                                   const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"run",
                                 find_slider_crank(),
                                 "--set",
                                 "study.cycles=" + std::to_string(cycles_),
                                 "--set",
                                 "study.outputs_per_cycle=" + outputs_,
                                 "--checkpoint-interval",
                                 "0.1",
                                 "-o",
                                 directory};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] std::filesystem::path checkpoint() const { return folder_.path() / "parts/base.h5.checkpoint"; }

  /// Starts or resumes it and sends the signal once it has written a checkpoint of its own. False when it ended before.
  bool run_and_send(int signal, bool resume) {
    const auto since = std::filesystem::file_time_type::clock::now();
    RunningProgram program(
        folder_, arguments("parts", resume ? std::vector<std::string>{"--resume"} : std::vector<std::string>{}));
    std::error_code none;
    for (int i = 0; i < 3000 && !program.has_ended(); ++i) {
      if (std::filesystem::exists(folder_.path() / "parts/base.h5")) {
        const auto written = std::filesystem::last_write_time(checkpoint(), none);
        if (!none && written > since) break;
      }
      std::this_thread::sleep_for(10ms);
    }
    program.send(signal);
    last_ = program.wait();
    return last_.exit_code == 128 + signal;
  }
  Outcome resume() { return last_ = run_program(folder_, arguments("parts", {"--resume"})); }

  void expect_same_numbers() {
    ASSERT_EQ(run_program(folder_, arguments("whole", {"--quiet"})).exit_code, 0);
    for (const std::string name : {"whole", "parts"}) {
      ASSERT_EQ(run_program(folder_, {"export", name + "/base.h5", "-o", "csv_" + name}).exit_code, 0);
    }
    int n_files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "csv_whole")) {
      ++n_files;
      EXPECT_TRUE(read_text(entry.path()) == read_text(folder_.path() / "csv_parts" / entry.path().filename()))
          << entry.path().filename();
    }
    EXPECT_GT(n_files, 3);
    EXPECT_FALSE(std::filesystem::exists(checkpoint())) << "it is gone with its stage";
  }

  TemporaryFolder folder_;
  int cycles_ = kCycles;
  std::string outputs_ = "50";
  Outcome last_;
};

TEST_F(CheckpointRun, KilledAgainAndAgainWithinAStageEndsWithTheSameNumbers) {
  cycles_ = kManyCycles;
  int n_kills = 0;
  while (n_kills < 6 && run_and_send(SIGKILL, n_kills > 0)) ++n_kills;
  EXPECT_GE(n_kills, 3);
  const Outcome end = resume();
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("base: goes on in stage "));
  expect_same_numbers();
  book::record_fault(
      {"kill within a stage, gone on from its checkpoint", n_kills, HasFailure() ? 1 : 0, "runs whose numbers differ"});
}

TEST_F(CheckpointRun, StoppedWithinAStageGoesOnWithItsSamples) {
  outputs_ = "1500";  // blocks are handed over before
  int n_stops = 0;
  while (n_stops < 2 && run_and_send(SIGTERM, n_stops > 0)) ++n_stops;
  EXPECT_GE(n_stops, 1);
  // A stop between two stages leaves none.
  const bool is_within = std::filesystem::exists(checkpoint());
  ASSERT_EQ(resume().exit_code, 0) << last_.err;
  EXPECT_EQ(last_.err.find("goes on in stage") != std::string::npos, is_within) << last_.err;
  expect_same_numbers();
}

TEST_F(CheckpointRun, ADamagedCheckpointIsToldAndNotUsed) {
  ASSERT_TRUE(run_and_send(SIGKILL, false));
  std::string bytes = read_text(checkpoint());
  ASSERT_GT(bytes.size(), 1000U);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(checkpoint(), std::ios::binary) << bytes;
  ASSERT_EQ(resume().exit_code, 0) << last_.err;
  EXPECT_THAT(last_.err, HasSubstr("base.h5.checkpoint: the checkpoint is damaged, or of another model"));
  EXPECT_THAT(last_.err, Not(HasSubstr("goes on in stage")));
  expect_same_numbers();
}

TEST_F(CheckpointRun, OneOfAnotherStudyIsNotUsed) {
  ASSERT_TRUE(run_and_send(SIGKILL, false));
  std::filesystem::rename(checkpoint(), folder_.path() / "other");
  std::filesystem::remove_all(folder_.path() / "parts");
  outputs_ = "60";
  ASSERT_TRUE(run_and_send(SIGKILL, false));
  std::filesystem::rename(folder_.path() / "other", checkpoint());
  ASSERT_EQ(resume().exit_code, 0) << last_.err;
  EXPECT_THAT(last_.err, HasSubstr("of another model, study or program"));
  expect_same_numbers();
}

TEST_F(CheckpointRun, OverwritingForgetsIt) {
  ASSERT_TRUE(run_and_send(SIGKILL, false));
  ASSERT_TRUE(std::filesystem::exists(checkpoint()));
  const Outcome again = run_program(folder_, arguments("parts", {"--overwrite", "--quiet"}));
  ASSERT_EQ(again.exit_code, 0) << again.err;
  expect_same_numbers();
}

}  // namespace
}  // namespace gudgeon::test
