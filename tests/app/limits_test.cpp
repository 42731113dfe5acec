// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Closed standard descriptors, and limits of the system: one clear line, the right exit code, and no word of a file
// that is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/program.h"
#include "tests/verification/book/record_fault.h"

namespace gudgeon::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kQuotedModel = "'" + find_slider_crank() + "'";
constexpr const char* kRunFile = "runs/slider_crank/base.h5";

/// The file reads back with all of its stages, whatever was printed meanwhile.
void expect_complete(const TemporaryFolder& folder) {
  const Outcome info = run_program(folder, {"info", kRunFile});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("wear_1"));
}

// A file opened where standard error should be would be given its text.
TEST(ClosedStreams, HarmNoRun) {
  int n_tried = 0;
  for (const char* closed : {">&-", "2>&-", "<&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    ++n_tried;
    const TemporaryFolder folder;
    const Outcome outcome = run_in_shell(folder, "exec \"$GUDGEON\" run " + kQuotedModel + " " + closed);
    EXPECT_EQ(outcome.exit_code, 0) << closed << outcome.err;
    expect_complete(folder);
  }
  book::record_fault({"standard streams closed from the start", n_tried, HasFailure() ? 1 : 0, "runs"});
}

TEST(ClosedStreams, HarmNoFileOfOtherCommands) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_in_shell(folder, "exec \"$GUDGEON\" run --quiet " + kQuotedModel).exit_code, 0);
  for (const std::string& command : {"draw " + kQuotedModel + " -o", std::string("report runs/slider_crank -o")}) {
    ASSERT_EQ(run_in_shell(folder, "exec \"$GUDGEON\" " + command + " open.svg").exit_code, 0);
    for (const std::string closed : {">&-", "2>&-", "<&- >&- 2>&-"}) {
      const Outcome outcome =
          run_in_shell(folder, "exec \"$GUDGEON\" " + command + " closed.svg --overwrite " + closed);
      EXPECT_EQ(outcome.exit_code, 0) << command << closed << outcome.err;
      EXPECT_EQ(read_text(folder.path() / "closed.svg"), read_text(folder.path() / "open.svg")) << command << closed;
    }
    std::filesystem::remove(folder.path() / "open.svg");
  }
}

// What was asked for is text, and there is nowhere to put it.
TEST(ClosedStreams, AreAnErrorWhereTextWasAskedFor) {
  const TemporaryFolder folder;
  for (const std::string& command :
       {"check " + kQuotedModel, std::string("laws"), std::string("--help"), "draw -o - " + kQuotedModel,
        "kinematics " + kQuotedModel, "equilibrium " + kQuotedModel}) {
    const Outcome outcome = run_in_shell(folder, "exec \"$GUDGEON\" " + command + " >&-");
    EXPECT_EQ(outcome.exit_code, 5) << command;
    EXPECT_THAT(outcome.err, HasSubstr("standard output is closed")) << command;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(run_in_shell(folder, "exec \"$GUDGEON\" check no_such.toml 2>&-").exit_code, 5);
}

/// What every run that a limit stopped must hold to.
void expect_honest(const TemporaryFolder& folder, const Outcome& outcome) {
  const bool told = outcome.err.find("what was finished is kept in runs") != std::string::npos;
  EXPECT_TRUE(!told || std::filesystem::exists(folder.path() / kRunFile)) << outcome.err;
  EXPECT_THAT(outcome.err, Not(AnyOf(HasSubstr("terminate"), HasSubstr("internal error"), HasSubstr("bad_alloc"))));
}

// In steps of 512 bytes: before the header, within the first stage, within a later one.
TEST(Limits, OfFileSizeEndARunLikeAFullDisk) {
  for (const int blocks : {1, 8, 40, 200, 400, 800}) {
    const TemporaryFolder folder;
    const Outcome outcome = run_in_shell(folder, "ulimit -f " + std::to_string(blocks) +
                                                     "; exec \"$GUDGEON\" run --quiet " + kQuotedModel + " 2>&1 | cat");
    expect_honest(folder, outcome);
    EXPECT_THAT(outcome.out, HasSubstr("File too large")) << blocks;
  }
  const TemporaryFolder folder;
  const Outcome outcome =
      run_in_shell(folder, "ulimit -f 1; \"$GUDGEON\" run --quiet " + kQuotedModel + " 2>/dev/null; echo $? | cat");
  EXPECT_EQ(outcome.out, "5\n");
}

// The limit forbids one thread's stack; 64 kilobytes for each are enough for nothing but to count.
TEST(Limits, OfThreadsAreToldInOneLine) {
#ifdef GUDGEON_SANITIZE
  GTEST_SKIP() << "sanitizers need more address space than any limit here";
#endif
  const TemporaryFolder none;
  const Outcome refused =
      run_in_shell(none, "ulimit -s 2000000; ulimit -v 1500000; exec \"$GUDGEON\" run --all-cases " + kQuotedModel);
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.err, HasSubstr("gudgeon: no thread can be made"));
  EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
  const TemporaryFolder some;
  const Outcome outcome = run_in_shell(
      some, "ulimit -s 600000; ulimit -v 1500000; exec \"$GUDGEON\" run --all-cases --threads 3 " + kQuotedModel);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("of 3 threads can be made"));
  expect_complete(some);
}

TEST(Limits, OfMemoryAreToldInOneLine) {
#ifdef GUDGEON_SANITIZE
  GTEST_SKIP() << "sanitizers need more address space than any limit here";
#endif
  bool any_stopped = false;
  // Closely where a run starts and has not enough: what lacks memory there differs from limit to limit.
  std::vector<int> limits{30000, 70000, 80000, 300000};
  for (int kilobytes = 40000; kilobytes <= 64000; kilobytes += 800) limits.push_back(kilobytes);
  for (const int kilobytes : limits) {
    const TemporaryFolder folder;
    const Outcome outcome = run_in_shell(folder, "ulimit -v " + std::to_string(kilobytes) +
                                                     "; exec \"$GUDGEON\" run --quiet --threads 1 " + kQuotedModel);
    if (outcome.exit_code == 127) continue;  // not even its libraries can be loaded
    expect_honest(folder, outcome);
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 4) << kilobytes << ": " << outcome.exit_code;
    if (outcome.exit_code == 0) {
      expect_complete(folder);
      continue;
    }
    any_stopped = true;
    EXPECT_THAT(outcome.err, AnyOf(HasSubstr("out of memory"), HasSubstr("no thread can be made")));
  }
  EXPECT_TRUE(any_stopped);
}

}  // namespace
}  // namespace gudgeon::test
