// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon laws, and the page of the manual that it makes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(LawsCommand, MakesThePageOfTheManual) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"laws", "--markdown"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, read_text(GUDGEON_SOURCE_DIR "/docs/guide/laws.md"))
      << "`gudgeon laws --markdown > docs/guide/laws.md` makes it anew";
}

TEST(LawsCommand, TellsOneLawOrOneFamily) {
  const TemporaryFolder folder;
  const Outcome one = run_program(folder, {"laws", "archard"});
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_THAT(one.out, HasSubstr("ḣ = k_d p |v|"));
  EXPECT_THAT(one.out, HasSubstr("required"));
  EXPECT_THAT(one.out, Not(HasSubstr("lugre")));
  const Outcome family = run_program(folder, {"laws", "friction"});
  EXPECT_THAT(family.out, HasSubstr("lugre_steady (friction)"));
  EXPECT_THAT(family.out, HasSubstr("dahl (friction)"));
  EXPECT_THAT(family.out, Not(HasSubstr("archard")));
}

TEST(LawsCommand, SuggestsTheNearestName) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"laws", "archrd"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("Did you mean 'archard'?"));
}

}  // namespace
}  // namespace gudgeon::test
