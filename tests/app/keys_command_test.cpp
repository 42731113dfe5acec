// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon keys, and the page of the manual that it makes. tests/schema/ holds its schema to what the program reads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(KeysCommand, MakesThePageOfTheManual) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"keys", "--markdown"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, read_text(GUDGEON_SOURCE_DIR "/docs/guide/keys.md"))
      << "`gudgeon keys --markdown > docs/guide/keys.md` makes it anew";
}

TEST(KeysCommand, TellsASectionATypeOrOneKey) {
  const TemporaryFolder folder;
  const Outcome section = run_program(folder, {"keys", "joints"});
  EXPECT_EQ(section.exit_code, 0);
  EXPECT_THAT(section.out, HasSubstr("[joints.NAME] type = \"pin_in_slot_clearance\""));
  EXPECT_THAT(section.out, Not(HasSubstr("[study]")));
  const Outcome type = run_program(folder, {"keys", "prismatic"});
  EXPECT_THAT(type.out, HasSubstr("start.displacement"));
  EXPECT_THAT(type.out, Not(HasSubstr("prismatic_clearance")));
  const Outcome key = run_program(folder, {"keys", "stiffness"});
  EXPECT_THAT(key.out, HasSubstr("stiffness, k"));
  EXPECT_THAT(key.out, HasSubstr("N m/rad"));
  EXPECT_THAT(key.out, Not(HasSubstr("damping")));
}

TEST(KeysCommand, SuggestsTheNearestName) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"keys", "relative_tolerence"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("Did you mean 'relative_tolerance'?"));
}

TEST(KeysCommand, LeadsOnToLawsPathsAndPresentNames) {
  const TemporaryFolder folder;
  EXPECT_THAT(run_program(folder, {"keys", "lugre"}).err, HasSubstr("`gudgeon laws` has the laws and their keys"));
  EXPECT_THAT(run_program(folder, {"keys", "kinetic_coefficient"}).err, HasSubstr("`gudgeon laws` has"));
  EXPECT_THAT(run_program(folder, {"keys", "regions"}).err, HasSubstr("an old name of 'cells'"));
  EXPECT_THAT(run_program(folder, {"keys", "study.wear_stages"}).out, HasSubstr("how often the surfaces are rebuilt"));
}

TEST(KeysCommand, TakesOneFormAtATime) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program(folder, {"keys", "--schema", "--markdown"}).exit_code, 2);
  EXPECT_EQ(run_program(folder, {"keys", "joints", "--schema"}).exit_code, 2);
}

}  // namespace
}  // namespace gudgeon::test
