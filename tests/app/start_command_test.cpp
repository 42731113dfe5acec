// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Starts as a user meets them: what run refuses, check refuses; all assemblies are listed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

std::string find_case_file(const std::string& name) {
  return std::string(GUDGEON_SOURCE_DIR) + "/tests/cases/" + name + ".toml";
}

TEST(StartCommand, CheckRefusesASingularStartAsRunDoes) {
  const TemporaryFolder folder;
  for (const char* command : {"check", "run"}) {
    const Outcome outcome = run_program(folder, {command, find_case_file("singular_start")});
    EXPECT_EQ(outcome.exit_code, 3) << command;
    EXPECT_THAT(outcome.err, HasSubstr("E-MODEL-073")) << command;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "runs")) << "nothing is left behind";
}

TEST(StartCommand, AllAssembliesOfAGroupOfClassThreeAreListed) {
  const TemporaryFolder folder;
  const Outcome listed = run_program(folder, {"kinematics", find_case_file("class3_branch"), "--branches"});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  EXPECT_THAT(listed.out, HasSubstr("Branch 2:"));
  EXPECT_THAT(listed.out, Not(HasSubstr("Branch 3:")));
  EXPECT_THAT(listed.out, ContainsRegex("P1 +54\\.49[67][0-9]* +174\\.09[78]"));
  EXPECT_THAT(listed.out, ContainsRegex("tern +-40\\.72[78]"));
  const Outcome asked =
      run_program(folder, {"check", find_case_file("class3_branch"), "--set", "joints.P3.branch=right"});
  EXPECT_EQ(asked.exit_code, 0) << asked.err;
  EXPECT_THAT(asked.out, ContainsRegex("tern +54\\.497[0-9]* +174\\.09[78][0-9]* +-40\\.72[78]"));
}

TEST(StartCommand, CheckTellsWhatClearanceAloneMakesPossible) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"check", find_case_file("pitch_error_within_clearance")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("R-MODEL-112: joint 'P2': its journal starts 0.05 mm off the middle"));
  EXPECT_THAT(outcome.out, HasSubstr("R-MODEL-113"));
}

}  // namespace
}  // namespace gudgeon::test
