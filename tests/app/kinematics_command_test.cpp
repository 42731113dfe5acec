// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon kinematics on a driven mechanism, one that is not, one that jams.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kFourBar = std::string(GUDGEON_SOURCE_DIR) + "/examples/four_bar.toml";

TEST(KinematicsCommand, SummarisesACrankRocker) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"kinematics", kFourBar, "--samples", "36", "-o", "csv"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  // cos μ = (b² + c² − (d − a)²)/(2bc) = 172/192, and in-line positions of 40, 120, 80, 100 mm.
  EXPECT_THAT(outcome.out, ContainsRegex("B +transmission +26\\.384°"));
  EXPECT_THAT(outcome.out, ContainsRegex("rocker +greatest +128\\.682°"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("nan")));
  EXPECT_THAT(read_text(folder.path() / "csv" / "kinematics_channels.csv"), HasSubstr("B.transmission_angle [rad]"));
  const Outcome again = run_program(folder, {"kinematics", kFourBar, "-o", "csv"});
  EXPECT_EQ(again.exit_code, 5) << "existing files stay";
}

TEST(KinematicsCommand, NeedsDrivers) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program(folder, {"kinematics", std::string(GUDGEON_SOURCE_DIR) + "/examples/pendulum.toml"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("E-MODEL-079"));
}

TEST(KinematicsCommand, JammedMotionKeepsItsBeginning) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program(folder, {"kinematics", kFourBar, "--set", "bodies.coupler.points.B=[\"50 mm\", 0]", "-o", "csv"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("E-NUM-010"));
  EXPECT_THAT(read_text(folder.path() / "csv" / "kinematics_channels.csv"), HasSubstr("rocker.angle"));
}

TEST(KinematicsCommand, ListsBranchesAndTakesOne) {
  const TemporaryFolder folder;
  const Outcome both = run_program(folder, {"kinematics", kFourBar, "--branches"});
  EXPECT_EQ(both.exit_code, 0);
  EXPECT_THAT(both.out, HasSubstr("Branch 1: joint 'B' left (the model's start)"));
  EXPECT_THAT(both.out, HasSubstr("Branch 2: joint 'B' right"));
  const Outcome asked = run_program(folder, {"check", kFourBar, "--set", "joints.B.branch=right"});
  EXPECT_THAT(asked.out, ContainsRegex("B +rocker +coupler +right"));
  const Outcome wrong = run_program(folder, {"check", kFourBar, "--set", "joints.A.branch=right"});
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_THAT(wrong.err, HasSubstr("E-MODEL-078"));
}

TEST(KinematicsCommand, ListsTheNineBarsBranches) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(
      folder, {"kinematics", std::string(GUDGEON_SOURCE_DIR) + "/examples/nine_bar/nine_bar.toml", "--branches"});
  EXPECT_EQ(outcome.exit_code, 0);
  // The rods' common pin below the cranks is beyond the panel's reach; the other two loops have both sides.
  EXPECT_THAT(outcome.out, HasSubstr("Branch 4:"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("Branch 5:")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("'D_rods' left")));
}

TEST(KinematicsCommand, NamesTheClearanceJointsThatItTakesAsIdeal) {
  const TemporaryFolder folder;
  const std::string press = std::string(GUDGEON_SOURCE_DIR) + "/examples/nine_bar/nine_bar.toml";
  EXPECT_THAT(run_program(folder, {"kinematics", press, "--samples", "4"}).out,
              HasSubstr("The clearance joints A, B are taken as ideal.\n"));
  EXPECT_THAT(run_program(folder, {"kinematics", kFourBar, "--branches"}).out,
              HasSubstr("The clearance joint B is taken as ideal.\n"));
}

TEST(KinematicsCommand, SaysWhereForcesAreShared) {
  const TemporaryFolder folder;
  folder.write("table.toml", R"(
name = "table"
gravity = [0, -9.81]
[bodies.frame]
points = { L = [0, 0], R = [1, 0] }
[bodies.table]
mass = 1
inertia = 1
points = { L = [0, 0], R = [1, 0] }
[joints.left]
type = "prismatic"
between = ["frame.L", "table.L"]
direction = "90 deg"
[joints.right]
type = "prismatic"
between = ["frame.R", "table.R"]
direction = "90 deg"
[drivers.lift]
slide = "left"
speed = "1 m/s"
[study]
cycle_time = 1
)");
  for (const char* command : {"kinematics", "equilibrium"}) {
    const Outcome outcome = run_program(folder, {command, "table.toml"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                HasSubstr("2 redundant constraints: of the many ways to share the load, joint forces are the least"));
    EXPECT_THAT(outcome.out, ContainsRegex("lift[a-z.]* +9.810 N"));
  }
}

TEST(KinematicsCommand, CountsMustMakeSense) {
  const TemporaryFolder folder;
  const Outcome none = run_program(folder, {"kinematics", kFourBar, "--samples", "0"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("--samples must be at least 2; it is 0"));
  EXPECT_EQ(run_program(folder, {"kinematics", kFourBar, "--cycles", "-1"}).exit_code, 2);
  EXPECT_EQ(run_program(folder, {"kinematics", kFourBar, "--samples", "100000000"}).exit_code, 2);
}

}  // namespace
}  // namespace gudgeon::test
