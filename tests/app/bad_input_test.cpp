// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Model files that no honest hand wrote: told in a few lines, whatever they hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;

std::string repeat(const std::string& piece, int times) {
  std::string text;
  for (int k = 0; k < times; ++k) text += piece;
  return text;
}

std::string replace(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// Neither file commands a terminal: no control character but newlines and tabs.
void expect_no_controls(const Outcome& outcome) {
  for (const std::string& text : {outcome.out, outcome.err}) {
    EXPECT_TRUE(std::ranges::none_of(text, [](unsigned char c) {
      return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
    })) << text;
  }
}

Outcome check(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("m.toml", text);
  Outcome outcome = run_program(folder, {"check", "m.toml"});
  expect_no_controls(outcome);
  EXPECT_LT(outcome.err.size(), 5000U);
  return outcome;
}

TEST(BadInput, OfThousandsOfLevelsIsRefused) {
  const std::string model = read_text(find_slider_crank());
  for (const std::string& text : {repeat("a.", 200000) + "a = 1\n" + model, model + "[" + repeat("a.", 200000) + "a]\n",
                                  "a = " + repeat("{" + repeat("a.", 99) + "a = ", 250) + "\n" + model}) {
    const Outcome outcome = check(text);
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("E-TOML-002"));
  }
}

TEST(BadInput, CommandsNoTerminal) {
  const std::string model = read_text(find_slider_crank());
  for (const auto& [from, to] : {std::pair{"name = \"slider_crank\"", "name = \"a\\u001b[2Jb\""},
                                 {"twice the clearance", "twice\\u009b31m"},
                                 {"[joints.A]", "[joints.\"A\\r\\u0008\"]"},
                                 {"\"50 mm\"", "\"50 \\u001b]0;title\\u0007mm\""},
                                 {"speed = \"1 rev/s\"", "motion = \"t + \\u001b[31m\""},
                                 {"name = \"slider_crank\"", "name = \"a\x1b[31mb\""},
                                 {"name = \"slider_crank\"", "name = \"a\xff\x9b\"\rx = 1"},
                                 {"cycles = 2", "\"cyc\\u202eles\" = 2"}}) {
    const Outcome outcome = check(replace(model, from, to));
    EXPECT_EQ(outcome.exit_code, 3) << to;
    EXPECT_THAT(outcome.err, HasSubstr("m.toml:"));
  }
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program(folder, {"check", find_slider_crank(), "--set", "\x1b[1Ajoints.A=\x1b[2J", "--case", "\x1b[31m"});
  EXPECT_EQ(outcome.exit_code, 3);
  expect_no_controls(outcome);
}

TEST(BadInput, OfAHundredKilobytesIsCutInMessages) {
  const std::string model = read_text(find_slider_crank());
  const std::string load = "[loads.q]\ntype = \"torque\"\nbody = \"crank\"\ntorque = \"";
  for (const std::string& formula :
       {repeat("t+", 50000) + "q", repeat("(", 50000) + "t" + repeat(")", 50000), repeat("-", 100000) + "t",
        repeat("t>0 ? ", 2000) + "t" + repeat(" : 1", 2000), "t" + repeat("+(t>1)", 3000), repeat("a", 100000)}) {
    const Outcome outcome = check(model + load + formula + "\"\n");
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("E-MODEL-08"));
  }
  EXPECT_EQ(check("name = \"" + repeat("n", 100000) + " \"\n" + model.substr(model.find("gravity"))).exit_code, 3);
  EXPECT_EQ(check(repeat("n", 100000) + " = 1\n" + model).exit_code, 3);
  EXPECT_EQ(check(model + repeat("n", 100000)).exit_code, 3);
}

// Neither in a terminal's time nor in an endless loop: values of any size end with a reason.
TEST(BadInput, OfAnySizeEndsWithAReason) {
  const std::string model = read_text(find_slider_crank());
  for (const std::string value : {"\"5e-324 s\"", "5e-324", "\"1e200 s\"", "1e-400", "\"1e-330 s\""}) {
    const Outcome outcome = check(replace(model, "cycle_driver = \"motor\"", "cycle_time = " + value));
    EXPECT_EQ(outcome.exit_code, 3) << value;
    EXPECT_THAT(outcome.err, HasSubstr("cycle_time is " + value));
  }
  const TemporaryFolder folder;
  for (const std::string setting :
       {"study.max_step=1e-90 s", "bodies.rod.points.S.0=1e90 m", "drivers.motor.speed=1e-90",
        "joints.pin.radial_clearance=1e-90 m", "materials.steel.young_modulus=1e90 Pa"}) {
    const Outcome outcome = run_program(folder, {"run", find_slider_crank(), "--overwrite", "--set", setting});
    EXPECT_TRUE(outcome.exit_code == 3 || outcome.exit_code == 4) << setting << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("E-"));
  }
}

}  // namespace
}  // namespace gudgeon::test
