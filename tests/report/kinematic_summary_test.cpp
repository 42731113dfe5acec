// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The text of a kinematic analysis, from a record written by hand.
#include "gudgeon/report/kinematic_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace gudgeon {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kPi = std::numbers::pi;

KinematicRecord make_record() {
  KinematicRecord record;
  record.driver = "motor";
  record.driver_unit = "rad";
  StageRecord& motion = record.motion;
  motion.cycle_time = 2.0;
  motion.end_time = 2.0;
  motion.time = {0.0, 1.0, 2.0};
  motion.channels = {
      {"rocker.angle", "θ", "rad", ""}, {"motor.effort", "T", "N m", ""}, {"motor.value", "φ", "rad", ""}};
  motion.values = {{0.0, 0.5 * kPi, -1e-9}, {3.0, -4.0, 3.0}, {0.0, kPi, 2.0 * kPi}};
  motion.statistics = {{"rocker.angle", -1e-9, 2.0, 0.5 * kPi, 1.0, 0.7, 0.8},
                       {"motor.effort", -4.0, 1.0, 3.0, 0.0, 0.0, 3.3},
                       {"motor.value", 0.0, 0.0, 2.0 * kPi, 2.0, kPi, 3.6}};
  record.transmissions.push_back({"B", false, 0.25 * kPi, {0.5, 0.5 * kPi}, 0.75 * kPi, {1.5, 1.5 * kPi}});
  record.transmissions.push_back({"slot", true, 0.0, {0.5, 0.5 * kPi}, 0.0, {1.5, 1.5 * kPi}});
  record.dead_centres.push_back({"rocker", "rad", {1.0, kPi}, 0.5 * kPi, true});
  return record;
}

TEST(KinematicSummary, GivesPlacesByTheDriver) {
  const std::string text = render_kinematics(make_record(), false);
  EXPECT_THAT(text, HasSubstr("3 samples up to t = 2 s, one cycle takes 2 s; \"at\" is the value of driver 'motor'"));
  EXPECT_THAT(text, ContainsRegex("rocker.angle +0.000° +360.000° +90.000° +180.000° +90.000°"));
  EXPECT_THAT(text, Not(HasSubstr("-0.000"))) << "no minus before zero";
  EXPECT_THAT(text, ContainsRegex("motor.effort +-4.000 N m +180.000° +3.000 N m +0.000° +3.300 N m"));
  EXPECT_THAT(text, ContainsRegex("B +transmission +45.000° +90.000° +135.000° +270.000°"));
  EXPECT_THAT(text, ContainsRegex("slot +pressure +0.000° +throughout +0.000° +throughout"));
  EXPECT_THAT(text, ContainsRegex("rocker +greatest +90.000° +180.000° +1 s"));
  EXPECT_THAT(text, Not(HasSubstr("branch changes")));
}

TEST(KinematicSummary, TellsBranchChangesAndTimesWithoutADriver) {
  KinematicRecord record = make_record();
  record.branch_changes.push_back({"pin", {0.5, 0.5 * kPi}, true});
  EXPECT_THAT(render_kinematics(record, false),
              HasSubstr("branch changes at joint 'pin' from right to left: t = 0.5 s, driver at 90.000°"));
  record.driver.clear();
  EXPECT_THAT(render_kinematics(record, false), ContainsRegex("rocker +greatest +90.000° +1 s +1 s"));
}

TEST(KinematicSummary, SaysLittleOfAMotionThatNeverBegan) {
  KinematicRecord record;
  record.motion.cycle_time = 2.0;
  EXPECT_EQ(render_kinematics(record, false), "0 samples up to t = 0 s, one cycle takes 2 s\n");
}

}  // namespace
}  // namespace gudgeon
