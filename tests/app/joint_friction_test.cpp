// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Friction in ideal joints from model files, through the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

TEST(JointFrictionFile, ABlockStopsWhereItsEnergyIsSpent) {
  const TemporaryFolder folder;
  const Outcome run = run_program(folder, {"run", find_case("friction_stops_block"), "--output", "runs"});
  ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, ContainsRegex("lost to friction +1\\.000 J"));
  const Outcome table = run_program(folder, {"export", "runs/base.h5", "-o", "csv", "--channel", "block.x"});
  ASSERT_EQ(table.exit_code, 0) << table.err;
  EXPECT_THAT(read_text(folder.path() / "csv" / "ideal_channels.csv"), HasSubstr("\n1,0.2038736"));
}

TEST(JointFrictionFile, ChecksTableNamesTheLaw) {
  const TemporaryFolder folder;
  const Outcome ideal = run_program(folder, {"check", find_case("friction_stops_block")});
  EXPECT_THAT(ideal.out, ContainsRegex("G +prismatic .*coulomb_ramp"));
  const Outcome contact = run_program(folder, {"check", find_slider_crank()});
  EXPECT_THAT(contact.out, ContainsRegex("pin +revolute_clearance .*coulomb_smooth"));
}

TEST(JointFrictionFile, TheReportNamesTheLaw) {
  const TemporaryFolder folder;
  const Outcome run =
      run_program(folder, {"run", find_slider_crank(), "--output", "runs", "--quiet", "--report", "--set",
                           "study.cycles=1", "--set", "study.wear_stages=0", "--set", "study.ideal_friction=true",
                           "--set", "joints.O.friction={law=\"threlfall\", kinetic_coefficient=0.1, pin_radius=0.01}"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string page = read_text(folder.path() / "runs" / "report.html");
  EXPECT_THAT(page, HasSubstr("Friction in O"));
  EXPECT_THAT(page, HasSubstr("threlfall"));
  EXPECT_THAT(page, HasSubstr("with the friction of the contacts that they replace"));
}

TEST(JointFrictionFile, AJammedGuideIsNamedWithItsTime) {
  const TemporaryFolder folder;
  const Outcome run = run_program(folder, {"run", find_case("friction_jams_guide")});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_THAT(run.out + run.err, HasSubstr("E-NUM-013: stopped at t = 6.27"));
  EXPECT_THAT(run.out + run.err, HasSubstr("joint 'guide' jams"));
  const Outcome followed = run_program(folder, {"kinematics", find_case("friction_jams_guide")});
  EXPECT_EQ(followed.exit_code, 4);
  EXPECT_THAT(followed.out + followed.err, HasSubstr("joint 'guide', driver 'motor' at 74.7"));
  EXPECT_THAT(followed.out + followed.err, HasSubstr("the joint jams"));
}

TEST(JointFrictionFile, WrongSizesAndLawsAreTold) {
  const TemporaryFolder folder;
  const std::string file = find_case("friction_stops_block");
  const Outcome negative = run_program(folder, {"check", file, "--set", "joints.G.friction.guide_length=-5 mm"});
  EXPECT_EQ(negative.exit_code, 3);
  EXPECT_THAT(negative.err, HasSubstr("E-MODEL-012"));
  const Outcome law = run_program(folder, {"check", file, "--set", "joints.G.friction.kinetic_coefficient=-0.1"});
  EXPECT_EQ(law.exit_code, 3);
  EXPECT_THAT(law.err, HasSubstr("joint 'G': friction"));
  const Outcome unknown = run_program(folder, {"check", file, "--set", "joints.G.friction.pin_radius=5 mm"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("pin_radius"));
}

}  // namespace
}  // namespace gudgeon::test
