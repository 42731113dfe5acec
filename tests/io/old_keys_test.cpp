// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Old names of keys are read as the present ones, wherever they stand, and noted at their place.
#include "gudgeon/io/old_keys.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/io/model_remarks.h"
#include "gudgeon/io/resolved_model.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kMechanism = R"(name = "a"
bodies.arm = { mass = 1, inertia = 1, points = { O = [0, 0] } }
joints.O = { type = "revolute", between = ["frame.O", "arm.O"] }
bodies.frame = { points = { O = [0, 0] } }
)";

ModelFile read(const std::string& rest, std::string_view case_name = {}, const std::vector<Override>& overrides = {}) {
  return read_model_text("m.toml", kMechanism + rest, case_name, overrides);
}

std::string messages(const ModelFile& model) { return render(model.diagnostics, model.source); }

TEST(OldKeys, OfAFileAreThePresentOnes) {
  const ModelFile old = read(R"([study]
regions = 40
magnification = "20"
deposition = "point"
[[study.published]]
quantity = "q"
channel = "arm.x"
measure = "peak"
values = [1, "2 m"]
)");
  const ModelFile present = read(R"([study]
cells = 40
wear_acceleration = "20"
wear_distribution = "point"
[[study.reference]]
quantity = "q"
channel = "arm.x"
measure = "peak"
values = [1, "2 m"]
)");
  ASSERT_FALSE(old.diagnostics.has_errors()) << messages(old);
  EXPECT_EQ(old.study.cells, 40);
  EXPECT_EQ(old.study.wear_acceleration, 20.0);
  EXPECT_EQ(old.study.wear_distribution, WearDistribution::point);
  ASSERT_EQ(old.study.reference.size(), 1U);
  EXPECT_EQ(write_resolved_model(old.mechanism, old.study), write_resolved_model(present.mechanism, present.study));
  EXPECT_THAT(messages(old), HasSubstr("m.toml:6:1: remark R-FILE-002: 'study.regions' is now called 'study.cells'\n"
                                       "    6 | regions = 40\n      | ^^^^^^^\n"));
  EXPECT_THAT(messages(old), HasSubstr("m.toml:7:1: remark R-FILE-002: 'study.magnification' is now called "
                                       "'study.wear_acceleration'\n"));
  EXPECT_THAT(messages(old), HasSubstr("m.toml:8:1: remark R-FILE-002: 'study.deposition' is now called "
                                       "'study.wear_distribution'\n"));
  EXPECT_THAT(messages(old), HasSubstr("m.toml:9:9: remark R-FILE-002: 'study.published' is now called "
                                       "'study.reference'\n"));
  EXPECT_THAT(messages(present), Not(HasSubstr("R-FILE-002")));
}

TEST(OldKeys, MessagesOfTheirValuesNameThePresentKeyAtTheValue) {
  const std::string text = messages(read("[study]\nregions = 4\n"));
  EXPECT_THAT(text, HasSubstr("m.toml:6:11: error E-STUDY-005: study: cells is 4"));
}

TEST(OldKeys, OfACaseAreNotedWhereTheCaseIsAsked) {
  for (const char* set : {"[cases.a]\nset = { \"study.regions\" = 30 }\n", "[cases.a.set]\nstudy.regions = 30\n"}) {
    const std::string text = std::string("[study]\ncells = 20\n[cases.b]\nset = {}\n") + set;
    const ModelFile model = read(text, "a");
    ASSERT_FALSE(model.diagnostics.has_errors()) << messages(model);
    EXPECT_EQ(model.study.cells, 30);
    ASSERT_EQ(model.cases.back().overrides.size(), 1U);
    EXPECT_EQ(model.cases.back().overrides[0].first, "study.cells");
    EXPECT_THAT(messages(model), HasSubstr("remark R-FILE-002: 'study.regions' is now called 'study.cells'"));
    EXPECT_THAT(messages(model), HasSubstr("m.toml:10:"));
    EXPECT_THAT(messages(read(text, "b")), Not(HasSubstr("R-FILE-002")));
    EXPECT_EQ(read(text).study.cells, 20);
  }
}

TEST(OldKeys, WrongValuesOfACaseHaveTheirPlace) {
  const std::string text = messages(read("[cases.a]\nset = { \"study.regions\" = 3 }\n", "a"));
  EXPECT_THAT(text, HasSubstr("m.toml:6:27: error E-STUDY-005: study: cells is 3"));
}

TEST(OldKeys, OfTheCommandLineAreNotedThere) {
  const ModelFile model = read("[study]\ncells = 20\n", {}, {{"study.regions", "50"}, {"study.magnification", "2"}});
  EXPECT_EQ(model.study.cells, 50);
  EXPECT_EQ(model.study.wear_acceleration, 2.0);
  EXPECT_EQ(model.overrides[0].path, "study.cells");
  EXPECT_THAT(messages(model), HasSubstr("--set study.regions=50: remark R-FILE-002: 'study.regions' is now called"));
}

TEST(OldKeys, WithinAValueThatIsSetArePresentOnes) {
  const ModelFile model = read("", {}, {{"study", "{ regions = 50, cycles = 2 }"}, {"study.published", "[]"}});
  ASSERT_FALSE(model.diagnostics.has_errors()) << messages(model);
  EXPECT_EQ(model.study.cells, 50);
  EXPECT_THAT(messages(model), HasSubstr("--set study={ regions = 50, cycles = 2 }: remark R-FILE-002"));
}

TEST(OldKeys, OfOneItemLeadToIt) {
  const ModelFile model =
      read("[[study.reference]]\nquantity = \"q\"\nchannel = \"c\"\nmeasure = \"peak\"\nvalues = [1]\n", {},
           {{"study.published.0.channel", "arm.x"}});
  ASSERT_EQ(model.study.reference.size(), 1U) << messages(model);
  EXPECT_EQ(model.study.reference[0].channel, "arm.x");
}

TEST(OldKeys, AreRefusedBesideThePresentOnesWithBothPlaces) {
  const std::string file = messages(read("[study]\ncells = 20\ncycles = 3\nregions = 30\n"));
  EXPECT_THAT(file,
              HasSubstr("m.toml:8:1: error E-FILE-017: 'study.regions' is the old name of 'study.cells', and both "
                        "are given\n"));
  EXPECT_THAT(file, HasSubstr("'study.cells' is given at line 6, column 1; remove 'study.regions'"));
  const std::string one_case = messages(read("[cases.a.set]\n\"study.regions\" = 30\n\"study.cells\" = 40\n", "a"));
  EXPECT_THAT(one_case, HasSubstr("m.toml:6:1: error E-FILE-017"));
  EXPECT_THAT(one_case, HasSubstr("'study.cells' is given at line 7, column 1; remove 'study.regions'"));
  const std::string line = messages(read("", {}, {{"study.regions", "50"}, {"study.cells", "60"}}));
  EXPECT_THAT(line, HasSubstr("--set study.regions=50: error E-FILE-017"));
  EXPECT_THAT(line, HasSubstr("'study.cells' is given at --set study.cells=60; remove"));
  const std::string value = messages(read("", {}, {{"study", "{ regions = 50, cells = 60 }"}}));
  EXPECT_THAT(value, HasSubstr("--set study={ regions = 50, cells = 60 }: error E-FILE-017"));
}

// Which one holds is plain where a case or the command line replaces what the file gives.
TEST(OldKeys, AreReplacedByPresentOnesAndReplaceThem) {
  const std::string old = "[study]\nregions = 20\n[cases.a]\nset = { \"study.cells\" = 30 }\n";
  EXPECT_EQ(read(old).study.cells, 20);
  EXPECT_EQ(read(old, "a").study.cells, 30);
  EXPECT_EQ(read(old, "a", {{"study.regions", "40"}}).study.cells, 40);
  EXPECT_FALSE(read(old, "a", {{"study.regions", "40"}}).diagnostics.has_errors());
}

TEST(OldKeys, AreNoKeysElsewhere) {
  EXPECT_THAT(messages(read("regions = 3\n")), HasSubstr("has no key 'regions'"));
  EXPECT_THAT(messages(read("[study]\nregion = 3\n")), HasSubstr("study has no key 'region'"));
  EXPECT_EQ(find_present_path("study.regions_of"), "study.regions_of");
  EXPECT_EQ(find_present_path("cases.study.regions"), "cases.study.regions");
}

TEST(OldKeys, OfCommentedValuesArePresentOnes) {
  const auto remarks = find_remarks("[study]\nregions = 3  # P\n[[study.published]]  # P\n");
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[0].path, "study.cells");
  EXPECT_EQ(remarks[1].path, "study.reference");
}

}  // namespace
}  // namespace gudgeon
