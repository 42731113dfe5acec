// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon diagnostics, the page of the manual that it makes, and that the list is that of the sources.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "gudgeon/base/diagnostic_list.h"
#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using testing::HasSubstr;

TEST(DiagnosticsCommand, MakesThePageOfTheManual) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"diagnostics", "--markdown"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, read_text(GUDGEON_SOURCE_DIR "/docs/guide/diagnostics.md"))
      << "`gudgeon diagnostics --markdown > docs/guide/diagnostics.md` makes it anew";
}

TEST(DiagnosticsCommand, TellsOneCodeOrAGroup) {
  const TemporaryFolder folder;
  const Outcome one = run_program(folder, {"diagnostics", "E-MODEL-013"});
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(one.out, "E-MODEL-013  error    radial_clearance is not below bearing_radius\n");
  EXPECT_THAT(run_program(folder, {"diagnostics", "R-STUDY"}).out, HasSubstr("R-STUDY-002  remark "));
}

TEST(DiagnosticsCommand, SuggestsTheNearestCode) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"diagnostics", "E-MODEL-0133"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("Did you mean 'E-MODEL-013'?"));
}

/// Codes within texts of the sources, the list itself left out.
std::set<std::string> find_codes_in_sources() {
  static const std::regex kCode("\"[^\"\n]*\\b([EWR]-[A-Z]+-[0-9]{3})\\b");
  std::set<std::string> codes;
  for (const auto& file : std::filesystem::recursive_directory_iterator(GUDGEON_SOURCE_DIR "/src/gudgeon")) {
    const std::string extension = file.path().extension();
    if ((extension != ".cpp" && extension != ".h") || file.path().stem() == "diagnostic_list") continue;
    const std::string text = read_text(file.path().string());
    for (std::sregex_iterator at(text.begin(), text.end(), kCode), end; at != end; ++at) codes.insert((*at)[1]);
  }
  return codes;
}

TEST(DiagnosticsCommand, ListsTheCodesOfTheSources) {
  std::set<std::string> listed;
  for (const DiagnosticEntry& entry : list_diagnostics()) {
    EXPECT_TRUE(listed.insert(std::string(entry.code)).second) << entry.code << " stands there twice";
    EXPECT_FALSE(entry.meaning.empty()) << entry.code;
  }
  EXPECT_EQ(find_codes_in_sources(), listed);
}

}  // namespace
}  // namespace gudgeon::test
