// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Start angles that are not taken, and those that are.
#include "gudgeon/system/start_remarks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;

std::vector<Diagnostic> find_remarks(const Mechanism& mechanism, const std::string& code = "R-MODEL-110") {
  const Diagnostics found = remark_start(mechanism, assemble(mechanism));
  std::vector<Diagnostic> remarks(found.items().begin(), found.items().end());
  std::erase_if(remarks, [&](const Diagnostic& one) { return one.code != code; });
  return remarks;
}

TEST(StartRemarks, ABlockInASlotThatARodHoldsKeepsTheSlotsAngle) {
  Mechanism mechanism = oracle::make_slider_crank_guide();
  Body& slider = mechanism.bodies[3];
  ASSERT_EQ(slider.name, "slider");
  const double slot = assemble(mechanism).poses[3].angle;
  slider.start.angle = slot + 0.02;
  EXPECT_NEAR(assemble(mechanism).angle_changes[3], -0.02, 1e-12) << "to rounding of angles";
  const auto found = find_remarks(mechanism);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "R-MODEL-110");
  EXPECT_EQ(found[0].path, "bodies.slider.start.angle");
  EXPECT_THAT(found[0].message, HasSubstr("body 'slider': its start angle is"));
  slider.start.angle = slot;
  EXPECT_TRUE(find_remarks(mechanism).empty());
}

TEST(StartRemarks, ALooseBlockTakesItsAngle) {
  BodyStart start;
  start.angle = 1e-3;
  EXPECT_TRUE(find_remarks(oracle::make_loose_block(start, 1e9)).empty());
}

TEST(StartRemarks, AGuessThatAssemblyImprovesIsNoneOfThem) {
  Mechanism mechanism = oracle::make_nine_bar();
  for (Body& body : mechanism.bodies) {
    if (body.start.angle) *body.start.angle += 0.2;
  }
  EXPECT_TRUE(find_remarks(mechanism).empty());
  const auto found = find_remarks(mechanism, "R-MODEL-111");
  ASSERT_EQ(found.size(), 1U) << "one for all guesses";
  EXPECT_THAT(found[0].message, HasSubstr("deg, and it starts 11.5 deg from there"));
  ASSERT_EQ(found[0].notes.size(), 4U);
  EXPECT_EQ(found[0].notes[2], "and 3 more");
}

TEST(StartRemarks, ADriversAngleIsLeftToItsOwnRemark) {
  Mechanism mechanism = oracle::make_nine_bar();
  mechanism.bodies[find_body(mechanism, "crank_1")].start.angle = 0.1;
  const Assembly assembly = assemble(mechanism);
  EXPECT_EQ(assembly.held_bodies.size(), 1U);
  EXPECT_TRUE(find_remarks(mechanism).empty());
}

}  // namespace
}  // namespace gudgeon
