// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Remarks behind values.
#include "gudgeon/io/model_remarks.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

constexpr const char* kText = R"(# A press.
#
#   P printed in the paper · A assumed
name = "press"  # not a number
gravity = ["9.81 m/s^2", 0]  # A: along x

[bodies.crank]               # I1: inferred
mass = "0.3 kg # not a remark"   # P
points = { A = [0, 0] }
values = [nan,
  2.0]  # inside a value of several lines

[cases.wide.set]
"joints.A.radial_clearance" = "0.8 mm"  # P
)";

TEST(ModelRemarks, StandBesideTheirValues) {
  const std::vector<ModelRemark> remarks = find_remarks(kText);
  ASSERT_EQ(remarks.size(), 4U);
  EXPECT_EQ(remarks[0].path, "name");
  EXPECT_EQ(remarks[1].path, "gravity");
  EXPECT_EQ(remarks[1].written, "[9.81 m/s^2, 0]");
  EXPECT_EQ(remarks[1].remark, "A: along x");
  EXPECT_EQ(remarks[2].path, "bodies.crank");
  EXPECT_EQ(remarks[2].written, "");
  EXPECT_EQ(remarks[3].path, "bodies.crank.mass");
  EXPECT_EQ(remarks[3].written, "0.3 kg # not a remark");
  EXPECT_EQ(remarks[3].remark, "P");
}

TEST(ModelRemarks, LettersAreThoseTheFileExplains) {
  const std::vector<RemarkLetter> letters = find_remark_letters(kText);
  ASSERT_EQ(letters.size(), 2U);
  EXPECT_EQ(letters[0].letter, "P");
  EXPECT_EQ(letters[0].meaning, "printed in the paper");
  EXPECT_EQ(letters[1].meaning, "assumed");
  EXPECT_TRUE(find_remark_letters("# a plain comment · with a dot\n").empty());
  EXPECT_TRUE(find_remark_letters("").empty());
}

}  // namespace
}  // namespace gudgeon
