// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts pressed beyond what their law or their bearing can be: the program says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Outcome run_case(const std::string& name) {
  const TemporaryFolder folder;
  return run_program(folder, {"run", GUDGEON_SOURCE_DIR "/tests/cases/" + name + ".toml"});
}

TEST(ContactLimits, TheEndOfALawIsNamed) {
  struct End {
    std::string file;
    std::string says;
    std::string depth;
  };
  for (const End& end :
       {End{"law_end_johnson", "its law johnson has no force beyond F = 4π E* w ΔR/e² = 58028 N",
            "penetration of 10.83 um"},
        End{"law_end_radzimovsky",
            "its law radzimovsky has no force beyond F = π E* w ΔR e^(−1/3) = "
            "4916 N",
            "penetration of 0.949"},
        End{"law_end_goldsmith", "its law goldsmith has no force beyond F = π E* w³/R_r", "penetration of 2.88"}}) {
    const Outcome outcome = run_case(end.file);
    EXPECT_EQ(outcome.exit_code, 4) << end.file;
    EXPECT_THAT(outcome.out + outcome.err, AllOf(HasSubstr("E-NUM-012"), HasSubstr(end.says), HasSubstr(end.depth)));
  }
}

TEST(ContactLimits, AJournalThroughItsBearingIsRemarkedOn) {
  const Outcome outcome = run_case("journal_through_bearing");
  EXPECT_THAT(outcome.out, HasSubstr("penetration of 2.19 m, beyond the bearing's radius of 20 mm"));
}

}  // namespace
}  // namespace gudgeon::test
