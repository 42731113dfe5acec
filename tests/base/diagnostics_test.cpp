// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rendering, places, and suggestions.
#include "gudgeon/base/diagnostics.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

SourceMap make_source() {
  SourceMap source;
  source.file = "press.toml";
  source.text = "[joints.A]\n\twidth = \"-1 mm\"  # breit\nα = \"日本\" ; x = 7\r\n";
  source.spans["joints.A"] = {1, 9, 1};
  source.spans["joints.A.width"] = {2, 10, 7};
  source.spans["x"] = {3, 16, 1};
  source.origins["study.cycles"] = "--set study.cycles=0";
  return source;
}

TEST(Render, ShowsPlaceLineCaretAndNotes) {
  Diagnostics diagnostics;
  diagnostics.error("E-MODEL-012", "joints.A.width", "joint 'A': width is wrong", {"make it right"});
  EXPECT_EQ(render(diagnostics, make_source()),
            "press.toml:2:10: error E-MODEL-012: joint 'A': width is wrong\n"
            "    2 | \twidth = \"-1 mm\"  # breit\n"
            "      | \t        ^^^^^^^\n"
            "   make it right\n"
            "1 error\n");
}

TEST(Render, CountsColumnsOfWideLetters) {
  Diagnostics diagnostics;
  diagnostics.error("E-X-001", "x", "seven");
  EXPECT_EQ(render(diagnostics, make_source()),
            "press.toml:3:16: error E-X-001: seven\n"
            "    3 | α = \"日本\" ; x = 7\n"
            "      |                  ^\n"
            "1 error\n");
}

TEST(Render, ShowsOfALongLineWhatIsAroundTheSpan) {
  SourceMap source;
  source.file = "table.toml";
  source.text = "α = [" + std::string(1000, '1') + "x" + std::string(1000, '2') + "]";
  source.spans["x"] = {1, 1006, 500};
  source.spans["α"] = {1, 1, 1};
  Diagnostics diagnostics;
  diagnostics.error("E-X-001", "x", "long");
  diagnostics.error("E-X-002", "α", "first");
  EXPECT_EQ(render(diagnostics, source), "table.toml:1:1: error E-X-002: first\n    1 | α = [" + std::string(155, '1') +
                                             "…\n      | ^\ntable.toml:1:1006: error E-X-001: long\n    1 | …" +
                                             std::string(60, '1') + "x" + std::string(99, '2') + "…\n      |  " +
                                             std::string(60, ' ') + std::string(100, '^') + "\n2 errors\n");
}

TEST(Render, PutsErrorsFirstAndCountsAll) {
  Diagnostics diagnostics;
  diagnostics.remark("R-1", "", "r");
  diagnostics.warning("W-1", "", "w");
  diagnostics.error("E-1", "x", "late");
  diagnostics.error("E-2", "joints.A", "early");
  diagnostics.error("E-3", "study.cycles", "overridden");
  const std::string text = render(diagnostics, make_source());
  EXPECT_LT(text.find("E-3"), text.find("E-2"));
  EXPECT_LT(text.find("E-2"), text.find("E-1"));
  EXPECT_LT(text.find("E-1"), text.find("W-1"));
  EXPECT_LT(text.find("W-1"), text.find("R-1"));
  EXPECT_NE(text.find("--set study.cycles=0: error E-3: overridden\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nwarning W-1: w\nremark R-1: r\n3 errors, 1 warning, 1 remark\n"), std::string::npos) << text;
}

TEST(Render, SaysNothingAboutNothing) { EXPECT_EQ(render({}, {}), ""); }

TEST(Render, SurvivesPlacesOutsideTheText) {
  SourceMap source = make_source();
  source.spans["far"] = {99, 99, 99};
  source.text += "\xff\xfe";
  source.spans["broken"] = {4, 2, 5};
  Diagnostics diagnostics;
  diagnostics.error("E-1", "far", "a");
  diagnostics.error("E-2", "broken", "b");
  EXPECT_NE(render(diagnostics, source).find("press.toml:99:99"), std::string::npos);
}

TEST(SourceMap, FindsTheNearestEnclosingTable) {
  const SourceMap source = make_source();
  ASSERT_NE(source.find("joints.A.contact.x"), nullptr);
  EXPECT_EQ(source.find("joints.A.contact.x")->line, 1);
  EXPECT_EQ(source.find("joints.B"), nullptr);
  EXPECT_EQ(source.find(""), nullptr);
  EXPECT_EQ(source.find_origin("joints.A.width"), nullptr);
  EXPECT_NE(source.find_origin("study.cycles"), nullptr);
}

TEST(Diagnostics, AppendKeepsAllAndKnowsErrors) {
  Diagnostics first;
  first.remark("R-1", "", "r");
  EXPECT_FALSE(first.has_errors());
  Diagnostics second;
  second.error("E-1", "", "e");
  first.append(second);
  first.append(first);
  EXPECT_EQ(first.items().size(), 4U);
  EXPECT_TRUE(first.has_errors());
}

TEST(ModelError, CarriesAndTellsItsDiagnostics) {
  Diagnostics diagnostics;
  diagnostics.error("E-1", "", "broken");
  const ModelError error{diagnostics};
  EXPECT_EQ(error.diagnostics().items().size(), 1U);
  EXPECT_STREQ(error.what(), "error E-1: broken\n1 error\n");
}

TEST(Suggest, FindsNearNamesOnly) {
  const std::vector<std::string> names{"frame", "crank_1", "crank_4", "rod_2", "S"};
  EXPECT_EQ(suggest("crank4", names), "Did you mean 'crank_4'?");
  EXPECT_EQ(suggest("farme", names), "Did you mean 'frame'?");
  EXPECT_EQ(suggest("FRAME", names), "Did you mean 'frame'?");
  EXPECT_EQ(suggest("slider_9", names), "");
  EXPECT_EQ(suggest("T", names), "");
  EXPECT_EQ(suggest("s", names), "");
  EXPECT_EQ(suggest("x", {}), "");
  EXPECT_EQ(join_names(names), "frame, crank_1, crank_4, rod_2, S");
}

}  // namespace
}  // namespace gudgeon
