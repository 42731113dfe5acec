// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The program's face: help, version, slips on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;

TEST(CommandLine, HelpTeachesByExamples) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("gudgeon run press.toml"));
  EXPECT_THAT(outcome.out, HasSubstr("Exit codes"));
  EXPECT_EQ(outcome.err, "");
}

TEST(CommandLine, EveryCommandHasHelpWithAnExample) {
  const TemporaryFolder folder;
  for (const std::string command : {"check", "draw", "run", "info", "export", "laws"}) {
    const Outcome outcome = run_program(folder, {command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_THAT(outcome.out, HasSubstr("\n  gudgeon " + command + " ")) << command;
  }
}

TEST(CommandLine, VersionIsOneLine) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, ::testing::MatchesRegex("gudgeon [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CommandLine, NothingIsAUsageError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("a command is missing"));
}

TEST(CommandLine, UnknownCommandSuggestsTheNearest) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"chek", "model.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("unknown command 'chek'. Did you mean 'check'?"));
}

TEST(CommandLine, UnknownOptionSuggestsTheNearest) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"run", "model.toml", "--thread=2"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("unknown option '--thread'. Did you mean '--threads'?"));
}

TEST(CommandLine, MissingFileArgumentIsNamed) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"check"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("FILE"));
}

TEST(CommandLine, SettingWithoutAValueIsAUsageError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"check", find_slider_crank(), "--set", "study.cycles"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("'study.cycles'"));
}

TEST(CommandLine, FullStandardOutputIsOneClearLine) {
  const TemporaryFolder folder;
  const Outcome outcome = RunningProgram(folder, {"check", find_slider_crank()}, "/dev/full").wait();
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_EQ(outcome.err, "gudgeon: standard output cannot be written: No space left on device\n");
}

}  // namespace
}  // namespace gudgeon::test
