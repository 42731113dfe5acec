// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Writing run files: stage by stage, and what is left when it goes wrong.
#include "gudgeon/io/run_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/safe_file.h"
#include "tests/io/scratch_directory.h"
#include "tests/results/synthetic_run.h"

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
  EXPECT_THAT(message, HasSubstr("exists already"));
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

/// In a process of its own whose files may not grow past the limit, as on a full disk.
std::string append_with_little_room(const std::filesystem::path& file, const RunRecord& run, rlim_t room) {
  std::signal(SIGXFSZ, SIG_IGN);
  RunWriter writer(file, run, false);
  writer.append(run.stages[0]);
  const rlimit limit{room, room};
  setrlimit(RLIMIT_FSIZE, &limit);
  return find_message<FileError>([&] { writer.append(run.stages[1]); });
}

TEST(RunWriter, FullDiskKeepsEarlierStages) {
  const ScratchDirectory scratch;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const std::string message = append_with_little_room(scratch / "x.h5", make_run(), 4096);
    ::_exit(message.find("cannot be written: File too large; make room") == std::string::npos ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(scratch / "x.h5.partial"));
}

TEST(RunWriter, WritingToAFullDeviceIsAnError) {
  const ScratchDirectory scratch;
  // the partial file leads to a device without room
  std::filesystem::create_symlink("/dev/full", scratch / "x.h5.partial");
  EXPECT_THAT(find_message<FileError>([&] { RunWriter(scratch / "x.h5", make_run(), false); }),
              HasSubstr("No space left on device; make room"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "x.h5"));
  EXPECT_FALSE(std::filesystem::is_symlink(scratch / "x.h5.partial"));
}

TEST(RunWriter, RefusesAStageTwiceAndNamesHdf5CannotHold) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  RunWriter writer(scratch / "x.h5", run, false);
  writer.append(run.stages[0]);
  EXPECT_THAT(find_message<FileError>([&] { writer.append(run.stages[0]); }),
              HasSubstr("stage 'ideal' cannot be added: a stage of that name is there already"));
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
  EXPECT_THAT(find_message<FileError>([&] { writer.append(run.stages[0]); }), HasSubstr("No such file"));
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
