// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Writing run files: stage by stage, and what is left when it goes wrong.
#include "gudgeon/io/run_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <span>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/safe_file.h"
#include "tests/io/scratch_directory.h"
#include "tests/results/synthetic_run.h"
#include "tests/verification/book/record_fault.h"

namespace gudgeon {
namespace {

using test::find_message;
using test::make_run;
using test::ScratchDirectory;
using testing::HasSubstr;

TEST(RunWriter, FileIsReadableAfterEveryStage) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter writer(scratch / "x.h5", run, false);
  EXPECT_TRUE(read_run(scratch / "x.h5").stages.empty());
  for (std::size_t k = 0; k < run.stages.size(); ++k) {
    writer.append(run.stages[k]);
    EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), k + 1);
    EXPECT_FALSE(std::filesystem::exists(scratch / "x.h5.partial"));
  }
}

TEST(RunWriter, ReplacesOnlyWhenAsked) {
  const ScratchDirectory scratch;
  test::write_text_file(scratch / "x.h5", "precious");
  const std::string message = find_message<FileError>([&] { RunWriter(scratch / "x.h5", make_run(), false); });
  EXPECT_THAT(message, HasSubstr((scratch / "x.h5").string()));
  EXPECT_THAT(message, HasSubstr("already exists"));
  EXPECT_EQ(test::read_text_file(scratch / "x.h5"), "precious");
  RunWriter(scratch / "x.h5", make_run(), true);
  EXPECT_EQ(read_run(scratch / "x.h5").case_name, "base");
}

TEST(RunWriter, NamesPathReasonAndNextStep) {
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch / "d.h5");
  for (const bool overwrite : {false, true}) {
    EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "d.h5", make_run(), overwrite); }),
                HasSubstr("Is a directory; choose another file name"));
  }
  EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "no/x.h5", make_run(), false); }),
              HasSubstr("No such file or directory; check the path"));
  EXPECT_THAT(find_message<FileError>([&] { RunWriter("/dev/full", make_run(), true); }),
              HasSubstr("/dev/full: cannot be written: it is not a regular file"));
}

TEST(RunWriter, TellsWhenTheDirectoryMayNotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const ScratchDirectory scratch;
  std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "x.h5", make_run(), false); }),
              HasSubstr("Permission denied"));
  std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_all);
}

TEST(RunWriter, LeftoverOfAKilledWriterDoesNoHarm) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  {
    RunWriter writer(scratch / "x.h5", run, false);
    writer.append(run.stages[0]);
    test::write_text_file(scratch / "x.h5.partial", "half a fi");
  }
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
  RunWriter writer(scratch / "x.h5", run, true);
  writer.append(run.stages[0]);
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(scratch / "x.h5.partial"));
}

/// A stage as it comes in blocks of so many samples: what is left for its end.
StageRecord append_in_blocks(RunWriter& writer, const StageRecord& stage, std::size_t size) {
  StageRecord rest = stage;
  while (rest.time.size() >= size) {
    SampleBlock block{stage.name, stage.channels, std::span(rest.time).first(size), {}};
    std::vector<std::vector<double>> values;
    for (std::vector<double>& of : rest.values) {
      values.emplace_back(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(size));
      of.erase(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(size));
    }
    block.values = values;
    writer.append(block);
    rest.time.erase(rest.time.begin(), rest.time.begin() + static_cast<std::ptrdiff_t>(size));
  }
  return rest;
}

TEST(RunWriter, BlocksGiveTheSameAsOnePiece) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  // One sample, a few, a divisor's neighbours, all but one, all.
  for (const std::size_t size : {1u, 7u, 100u, 200u, 201u}) {
    RunWriter writer(scratch / "x.h5", run, true);
    for (const StageRecord& stage : run.stages) writer.append(append_in_blocks(writer, stage, size));
    const RunRecord back = read_run(scratch / "x.h5");
    ASSERT_EQ(back.stages.size(), run.stages.size());
    for (std::size_t s = 0; s < run.stages.size(); ++s) {
      EXPECT_EQ(back.stages[s].name, run.stages[s].name);
      EXPECT_EQ(back.stages[s].time, run.stages[s].time) << size;
      EXPECT_EQ(back.stages[s].values, run.stages[s].values) << size;
      EXPECT_EQ(back.stages[s].end_time, run.stages[s].end_time);
      EXPECT_EQ(back.stages[s].statistics.size(), run.stages[s].statistics.size());
      EXPECT_EQ(back.stages[s].wear.size(), run.stages[s].wear.size());
      ASSERT_EQ(back.stages[s].channels.size(), run.stages[s].channels.size());
      for (std::size_t k = 0; k < run.stages[s].channels.size(); ++k) {
        EXPECT_EQ(back.stages[s].channels[k].name, run.stages[s].channels[k].name);
        EXPECT_EQ(back.stages[s].channels[k].unit, run.stages[s].channels[k].unit);
      }
    }
  }
}

TEST(RunWriter, AStageUnderWayIsNotInTheFile) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  std::uintmax_t size = 0;
  {
    RunWriter writer(scratch / "x.h5", run, false);
    writer.append(run.stages[0]);
    size = std::filesystem::file_size(scratch / "x.h5");
    append_in_blocks(writer, run.stages[1], 100);
    EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
    EXPECT_GT(std::filesystem::file_size(scratch / "x.h5"), size);
  }
  EXPECT_EQ(std::filesystem::file_size(scratch / "x.h5"), size);
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
}

TEST(RunWriter, BlocksBeginOverTheLeftoverOfAKilledWriter) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter writer(scratch / "x.h5", run, false);
  test::write_text_file(scratch / "x.h5.partial", std::string(1u << 20, 'x'));
  writer.append(append_in_blocks(writer, run.stages[0], 50));
  EXPECT_EQ(read_run(scratch / "x.h5").stages.at(0).values, run.stages[0].values);
  EXPECT_LT(std::filesystem::file_size(scratch / "x.h5"), 1u << 20);
}

TEST(RunWriter, TakesOverNamedStages) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  {
    RunWriter writer(scratch / "x.h5", run, false);
    writer.append(append_in_blocks(writer, run.stages[0], 50));
    for (const std::size_t k : {1u, 2u}) writer.append(run.stages[k]);
  }
  const std::vector<std::string> kept{run.stages[0].name, run.stages[1].name};
  RunWriter writer(scratch / "x.h5", run, true, kept);
  const RunRecord back = read_run(scratch / "x.h5");
  ASSERT_EQ(back.stages.size(), 2u);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(back.stages[s].name, run.stages[s].name);
    EXPECT_EQ(back.stages[s].time, run.stages[s].time);
    EXPECT_EQ(back.stages[s].values, run.stages[s].values);
  }
  writer.append(run.stages[2]);
  EXPECT_EQ(read_run(scratch / "x.h5").stages.at(2).values, run.stages[2].values);
  const std::vector<std::string> unknown{"wear_9"};
  EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "x.h5", run, true, unknown); }),
              HasSubstr("its stages cannot be taken over"));
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 3u);
}

/// The first n samples of a stage handed over in one block; what is left for its end.
StageRecord append_first(RunWriter& writer, const StageRecord& stage, std::size_t n) {
  StageRecord rest = stage;
  std::vector<std::vector<double>> values;
  const auto count = static_cast<std::ptrdiff_t>(n);
  for (std::vector<double>& of : rest.values) {
    values.emplace_back(of.begin(), of.begin() + count);
    of.erase(of.begin(), of.begin() + count);
  }
  writer.append(SampleBlock{stage.name, stage.channels, std::span(rest.time).first(n), values});
  rest.time.erase(rest.time.begin(), rest.time.begin() + count);
  return rest;
}

TEST(RunWriter, GoesOnWithAStageThatAKillLeft) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  StageUnderWay under_way{run.stages[1].name, 100, {}};
  StageRecord rest;
  std::string left;
  {
    RunWriter writer(scratch / "x.h5", run, false);
    writer.append(run.stages[0]);
    rest = append_first(writer, run.stages[1], 100);
    under_way.saved = writer.save_stage_under_way();
    append_first(writer, rest, 50);
    left = test::read_text_file(scratch / "x.h5");
  }
  const std::vector<std::string> kept{run.stages[0].name};
  for (const bool is_killed_again : {true, false}) {
    test::write_text_file(scratch / "x.h5", left);
    RunWriter writer(scratch / "x.h5", run, true, kept, &under_way);
    EXPECT_TRUE(writer.has_samples_under_way());
    EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
    if (is_killed_again) {
      append_first(writer, rest, 7);
      left = test::read_text_file(scratch / "x.h5");
    } else {
      writer.append(rest);
    }
  }
  const RunRecord back = read_run(scratch / "x.h5");
  EXPECT_EQ(back.stages.at(1).values, run.stages[1].values);
  EXPECT_EQ(back.stages.at(1).time, run.stages[1].time);
}

TEST(RunWriter, GoesOnWithAStageThatWasStopped) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  StageUnderWay under_way{run.stages[1].name, 100, {}};
  StageRecord rest;
  {
    RunWriter writer(scratch / "x.h5", run, false);
    writer.append(run.stages[0]);
    rest = append_first(writer, run.stages[1], 100);
    under_way.saved = writer.save_stage_under_way();
    StageRecord stopped = rest;
    stopped.status = StageStatus::stopped;
    stopped.time.resize(20);
    for (auto& values : stopped.values) values.resize(20);
    writer.append(stopped);
  }
  EXPECT_EQ(read_run(scratch / "x.h5").stages.at(1).time.size(), 120u);
  const std::vector<std::string> kept{run.stages[0].name};
  {
    // Until it is ended anew, what was stopped stays in the file.
    RunWriter writer(scratch / "x.h5", run, true, kept, &under_way);
    EXPECT_TRUE(writer.has_samples_under_way());
    EXPECT_EQ(read_run(scratch / "x.h5").stages.at(1).time.size(), 120u);
  }
  RunWriter writer(scratch / "x.h5", run, true, kept, &under_way);
  writer.append(rest);
  const RunRecord back = read_run(scratch / "x.h5");
  ASSERT_EQ(back.stages.size(), 2u);
  EXPECT_EQ(back.stages[1].values, run.stages[1].values);
  EXPECT_EQ(back.stages[1].status, StageStatus::finished);
}

TEST(RunWriter, AStageUnderWayThatIsNotThereBeginsAnew) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  {
    RunWriter writer(scratch / "x.h5", run, false);
    for (const std::size_t k : {0u, 1u}) writer.append(run.stages[k]);
  }
  const std::vector<std::string> kept{run.stages[0].name};
  // In the file as one piece, with fewer samples than that; another name; and none handed over.
  for (const StageUnderWay& under_way : {StageUnderWay{"no_wear", 1000, "not saved"}, StageUnderWay{"wear_7", 10, ""},
                                         StageUnderWay{"no_wear", 0, ""}}) {
    RunWriter writer(scratch / "x.h5", run, true, kept, &under_way);
    EXPECT_FALSE(writer.has_samples_under_way());
    writer.append(run.stages[1]);
    EXPECT_EQ(read_run(scratch / "x.h5").stages.at(1).values, run.stages[1].values);
  }
}

/// In a process of its own whose files may not grow past the limit, as on a full disk.
/// The exit code is 0 when the writer tells so, and when HDF5 is well afterwards.
int append_with_little_room(const std::filesystem::path& file, const RunRecord& run, int room, std::size_t block) {
  std::signal(SIGXFSZ, SIG_IGN);
  RunWriter writer(file, run, false);
  writer.append(run.stages[0]);
  const rlimit limit{static_cast<rlim_t>(static_cast<int>(std::filesystem::file_size(file)) + room), RLIM_INFINITY};
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string message = find_message<FileError>([&] {
    for (int k = 0; k < 1000; ++k) {
      StageRecord stage = run.stages[1];
      stage.name += std::to_string(k);
      writer.append(append_in_blocks(writer, stage, block));
    }
  });
  const std::string wanted = file.string() + ": cannot be written: File too large; make room";
  if (message.find(wanted) == std::string::npos) return 1;
  if (std::filesystem::exists(file.string() + ".partial")) return 2;
  const rlimit no_limit{RLIM_INFINITY, RLIM_INFINITY};
  setrlimit(RLIMIT_FSIZE, &no_limit);
  writer.append(run.stages[2]);
  return 0;
}

/// Room in bytes beyond a file with one stage, and the samples of a block.
class FullDisk : public testing::TestWithParam<std::tuple<int, std::size_t>> {};

TEST_P(FullDisk, KeepsEarlierStages) {
  const ScratchDirectory scratch;
  const auto [room, block] = GetParam();
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) ::_exit(append_with_little_room(scratch / "x.h5", make_run(), room, block));
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  const RunRecord back = read_run(scratch / "x.h5");
  const int n_lost = (back.stages.front().values == make_run().stages[0].values ? 0 : 1) +
                     (back.stages.back().values == make_run().stages[2].values ? 0 : 1);
  book::record_fault({"full disk, within every part of a stage and stages later", 1, n_lost, "finished stages"});
  EXPECT_FALSE(std::filesystem::exists(scratch / "x.h5.partial"));
}

// In one piece and in blocks; full within the copy, at once, within the metadata of a stage, within its samples, stages
// later.
INSTANTIATE_TEST_SUITE_P(RunWriter, FullDisk,
                         testing::Combine(testing::Values(-1, 0, 100, 3000, 10000, 20000, 100000),
                                          testing::Values<std::size_t>(1000, 100, 10)));

TEST(RunWriter, WhatIsNoRegularFileIsNotWrittenOver) {
  const ScratchDirectory scratch;
  test::write_text_file(scratch / "precious", "precious");
  std::filesystem::create_symlink("precious", scratch / "x.h5.partial");
  EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "x.h5", make_run(), false); }),
              HasSubstr("x.h5.partial: cannot be created: what is there is no regular file"));
  EXPECT_EQ(test::read_text_file(scratch / "precious"), "precious");
  EXPECT_TRUE(std::filesystem::is_symlink(scratch / "x.h5.partial"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "x.h5"));
  std::filesystem::remove(scratch / "x.h5.partial");
  ASSERT_EQ(::mkfifo((scratch / "x.h5.partial").c_str(), 0600), 0);
  EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "x.h5", make_run(), false); }),
              HasSubstr("is no regular file"));
}

TEST(RunWriter, ReplacesNothingWhereNoJournalCanBe) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter(scratch / "x.h5", run, false).append(run.stages[0]);
  std::filesystem::create_directories(scratch / "x.h5.journal/x");
  EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "x.h5", run, true); }),
              HasSubstr("x.h5.journal: is no regular file where the run's journal belongs"));
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
}

TEST(RunWriter, AJournalLargerThanItsFileIsLeftUnread) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter(scratch / "x.h5", run, false).append(run.stages[0]);
  test::write_text_file(scratch / "x.h5.journal", "");
  std::filesystem::resize_file(scratch / "x.h5.journal", std::uintmax_t{1} << 36U);  // a hole
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
}

TEST(RunWriter, RefusesAStageTwiceAndNamesHdf5CannotHold) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter writer(scratch / "x.h5", run, false);
  writer.append(run.stages[0]);
  EXPECT_THAT(find_message<FileError>([&] { writer.append(run.stages[0]); }),
              HasSubstr("stage 'ideal' cannot be added: a stage of that name already exists"));
  StageRecord odd = run.stages[1];
  odd.channels[0].name = "a/b";
  EXPECT_THAT(find_message<FileError>([&] { writer.append(odd); }), HasSubstr("'a/b' cannot be a name"));
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
}

TEST(RunWriter, TellsWhenItsFileWasTakenAway) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter writer(scratch / "x.h5", run, false);
  std::filesystem::remove(scratch / "x.h5");
  EXPECT_THAT(find_message<FileError>([&] { writer.append(run.stages[0]); }),
              HasSubstr("another program replaced or changed it"));
}

TEST(RunWriter, TellsWhenAnotherRunReplacedItsFile) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter writer(scratch / "x.h5", run, false);
  writer.append(run.stages[0]);
  RunRecord other = run;
  other.case_name = "other";
  RunWriter(scratch / "x.h5", other, true).append(run.stages[1]);
  EXPECT_THAT(find_message<FileError>([&] { writer.append(run.stages[1]); }),
              HasSubstr("another program replaced or changed it"));
  const RunRecord back = read_run(scratch / "x.h5");
  EXPECT_EQ(back.case_name, "other");
  EXPECT_EQ(back.stages.size(), 1u);
}

TEST(RunWriter, SeveralThreadsWriteSeveralFiles) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k) {
      threads.emplace_back([&, k] {
        RunWriter writer(scratch / (std::to_string(k) + ".h5"), run, false);
        for (const StageRecord& stage : run.stages) writer.append(stage);
      });
    }
  }
  for (int k = 0; k < 4; ++k) EXPECT_EQ(read_run(scratch / (std::to_string(k) + ".h5")).stages.size(), 3u);
}

}  // namespace
}  // namespace gudgeon
