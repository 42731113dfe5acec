// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon check on sound and unsound models.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

TEST(CheckCommand, CountsASoundModel) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"check", find_slider_crank()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  // Three bodies; two revolute joints, a guide and a driver; the clearance joint takes nothing.
  EXPECT_THAT(outcome.out, ContainsRegex("moving bodies +3"));
  EXPECT_THAT(outcome.out, ContainsRegex("coordinates +9"));
  EXPECT_THAT(outcome.out, ContainsRegex("constraint rows +7"));
  EXPECT_THAT(outcome.out, ContainsRegex("degrees of freedom +2"));
  EXPECT_THAT(outcome.out, HasSubstr("One cycle takes 1 s."));
}

TEST(CheckCommand, ListsJointsLoadsAndDrivers) {
  const TemporaryFolder folder;
  std::string text = read_text(find_slider_crank());
  text += "[loads.damper]\npoint = \"slider.S\"\nforce = [\"-c*slider.x_velocity\", 0]\nconstants = { c = 2 }\n";
  text += "[loads.coil]\ntype = \"torsion_spring\"\nbetween = [\"frame\", \"crank\"]\nstiffness = 2\n";
  const std::string file = folder.write("loads.toml", text).filename();
  const Outcome outcome = run_program(folder, {"check", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("pin +revolute_clearance +rod.S +slider.S +0.1 mm radial"));
  EXPECT_THAT(outcome.out, HasSubstr("gravity: [0, -9.81] m/s^2"));
  EXPECT_THAT(outcome.out, HasSubstr("[-c*slider.x_velocity, 0 N]"));
  EXPECT_THAT(outcome.out, ContainsRegex("coil +torsion_spring +frame to crank +2 N m/rad"));
  const Outcome moved = run_program(folder, {"check", file, "--set", "drivers.motor.motion=1 + 0.1*sin(2*pi*t)",
                                             "--set", "study.cycle_time=1", "--set", "gravity=[0, 0]"});
  EXPECT_EQ(moved.exit_code, 0) << moved.err;
  EXPECT_THAT(moved.out, HasSubstr("gravity: none"));
  EXPECT_THAT(moved.out, ContainsRegex("motor +angle of crank +57.2958 deg +1 . 0.1\\*sin"));
}

TEST(CheckCommand, TellsAStartAngleThatIsNotTaken) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program(folder, {"check", find_slider_crank(), "--set", "bodies.slider.start={angle=\"1 deg\"}"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("R-MODEL-110: body 'slider': its start angle is 1 deg, and it starts at 0 deg"));
  EXPECT_THAT(outcome.out, ContainsRegex("slider .* 0\\.0000 +-1\\.0000"));
}

TEST(CheckCommand, CaseAndSettingChangeTheModel) {
  const TemporaryFolder folder;
  const Outcome slow = run_program(folder, {"check", find_slider_crank(), "--case", "slow"});
  EXPECT_THAT(slow.out, HasSubstr("One cycle takes 2 s."));
  const Outcome set = run_program(folder, {"check", find_slider_crank(), "--set", "drivers.motor.speed=4 rev/s"});
  EXPECT_THAT(set.out, HasSubstr("One cycle takes 0.25 s."));
}

TEST(CheckCommand, ResolvedModelShowsDefaults) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"check", find_slider_crank(), "--resolved"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("relative_tolerance"));
  EXPECT_EQ(run_program(folder, {"check", find_slider_crank(), "--explain"}).out, outcome.out) << "its old name";
}

TEST(CheckCommand, ReportsAllErrorsAtOnce) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program(folder, {"check", find_slider_crank(), "--set", "joints.pin.radial_clearance=-1 mm", "--set",
                           "bodies.crank.mass=3 m", "--set", "contacts.steel.friction.law=lugre_stedy"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("E-MODEL-012"));
  EXPECT_THAT(outcome.err, HasSubstr("body 'crank': mass is \"3 m\""));
  EXPECT_THAT(outcome.err, HasSubstr("lugre_steady"));
}

TEST(CheckCommand, ErrorsShowTheLine) {
  const TemporaryFolder folder;
  std::string text = read_text(find_slider_crank());
  text.replace(text.find("\"0.1 mm\""), 8, "\"-0.1 mm\"");
  const Outcome outcome = run_program(folder, {"check", folder.write("bad.toml", text).filename()});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, ContainsRegex("bad\\.toml:[0-9]+:[0-9]+: error E-MODEL-012"));
  EXPECT_THAT(outcome.err, HasSubstr("^^^^^^^^^"));
}

/// What `check` says of the slider-crank with more lines at its end.
std::string find_complaint(const std::string& lines) {
  const TemporaryFolder folder;
  const std::string text = read_text(find_slider_crank());
  const Outcome outcome = run_program(folder, {"check", folder.write("m.toml", text + lines).filename()});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, "");
  // Places count from the lines that were added.
  const auto n_lines = std::count(text.begin(), text.end(), '\n');
  std::string complaint = outcome.err;
  for (int line = 1; line <= 6; ++line) {
    const std::string at = std::to_string(n_lines + line);
    for (const auto& [before, after] : {std::pair{":", ":"}, std::pair{" ", " |"}}) {  // not within a code
      const std::size_t found = complaint.find(before + at + after);
      if (found != std::string::npos) complaint.replace(found + 1, at.size(), "+" + std::to_string(line));
    }
  }
  return complaint;
}

TEST(CheckCommand, PointsAtTheFaultInAFormula) {
  EXPECT_EQ(find_complaint("[loads.motor]\nbody = \"crank\"\ntorque = \"2 * sin(3*t) + * 4\"\n"),
            "m.toml:+3:26: error E-MODEL-081: load 'motor': torque: \"2 * sin(3*t) + * 4\" is not a valid expression: "
            "'*' does not "
            "fit here\n"
            "   +3 | torque = \"2 * sin(3*t) + * 4\"\n"
            "      |                          ^\n"
            "1 error\n");
}

TEST(CheckCommand, PointsAtTheEntryThatDoesNotIncrease) {
  EXPECT_EQ(find_complaint("[loads.motor]\nbody = \"crank\"\ntorque = { over = \"t\", arguments = [0, 3, 2], values = "
                           "[1, 2, 3] }\n"),
            "m.toml:+3:43: error E-MODEL-085: load 'motor': torque: arguments must increase; entry 2 is 3 and entry 3 "
            "is 2\n"
            "   +3 | torque = { over = \"t\", arguments = [0, 3, 2], values = [1, 2, 3] }\n"
            "      |                                           ^\n"
            "1 error\n");
}

TEST(CheckCommand, PointsAtALoadWithoutAValue) {
  EXPECT_EQ(find_complaint("[loads.motor]\nbody = \"crank\"\ntorque = \"1/0\"\n"),
            "m.toml:+3:10: error E-MODEL-089: load 'motor': torque \"1/0\" has no finite value at the start\n"
            "   +3 | torque = \"1/0\"\n"
            "      |          ^^^^^\n"
            "   look at where it is defined: a division by zero, a root or a logarithm of what is negative\n"
            "1 error\n");
}

TEST(CheckCommand, PointsAtASpringWithoutLength) {
  EXPECT_EQ(find_complaint("[loads.coil]\ntype = \"spring\"\nbetween = [\"rod.S\", \"slider.S\"]\nstiffness = "
                           "2\nfree_length = \"1 mm\"\n"),
            "m.toml:+1:8: error E-MODEL-075: load 'coil': its two points coincide at the start, so the spring has no "
            "direction\n"
            "   +1 | [loads.coil]\n"
            "      |        ^^^^\n"
            "   give it two points apart, or use a bushing, which pulls two points together from wherever they are\n"
            "1 error\n");
}

TEST(CheckCommand, MechanismThatDoesNotCloseIsAModelError) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program(folder, {"check", find_slider_crank(), "--set", "bodies.rod.points.S=[\"20 mm\", 0]"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("mm"));
}

TEST(CheckCommand, BrokenSyntaxIsAModelError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"check", folder.write("bad.toml", "name = \n[bodies")});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("E-TOML-001"));
}

TEST(CheckCommand, MissingFileIsAFileError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"check", "none.toml"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("none.toml"));
}

}  // namespace
}  // namespace gudgeon::test
