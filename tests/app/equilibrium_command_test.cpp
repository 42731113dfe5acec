// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon equilibrium: a model without a study, one without an equilibrium.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

constexpr const char* kBar = R"(
name = "bar"
gravity = [0, "-9.81 m/s^2"]
[bodies.frame]
points = { O = [0, 0] }
[bodies.bar]
mass = "2 kg"
inertia = "0.16666666666666667 kg m^2"
center_of_mass = ["0.5 m", 0]
points = { O = [0, 0] }
start = { angle = "-60 deg" }
[joints.O]
type = "revolute"
between = ["frame.O", "bar.O"]
)";

TEST(EquilibriumCommand, NeedsNoStudy) {
  const TemporaryFolder folder;
  folder.write("bar.toml", kBar);
  const Outcome outcome = run_program(folder, {"equilibrium", "bar.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("-90.000000°"));
  EXPECT_THAT(outcome.out, HasSubstr("Small motions: stable"));
  EXPECT_THAT(outcome.out, HasSubstr("0.610"));  // √(3 g/(2 L))/2π Hz
  EXPECT_THAT(outcome.out, ContainsRegex("O +19\\.62 N"));
  const Outcome upright = run_program(folder, {"equilibrium", "bar.toml", "--set", "bodies.bar.start.angle=80 deg"});
  EXPECT_THAT(upright.out, HasSubstr("unstable in mode 1"));
}

TEST(EquilibriumCommand, ListsAll) {
  const TemporaryFolder folder;
  folder.write("bar.toml", kBar);
  const Outcome outcome = run_program(folder, {"equilibrium", "bar.toml", "--all"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Equilibrium 1 of 2: stable"));
  EXPECT_THAT(outcome.out, HasSubstr("Equilibrium 2 of 2: unstable in mode 1"));
}

TEST(EquilibriumCommand, NoEquilibriumIsANumericalError) {
  const TemporaryFolder folder;
  folder.write("bar.toml", std::string(kBar) + "[loads.motor]\nbody = \"bar\"\ntorque = \"30 N m\"\n");
  const Outcome outcome = run_program(folder, {"equilibrium", "bar.toml"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("E-NUM-011: no equilibrium was found"));
  EXPECT_THAT(outcome.err, HasSubstr("'bar' at rest would still accelerate"));
}

TEST(EquilibriumCommand, HoldsDriversAndClosesClearances) {
  const TemporaryFolder folder;
  const std::string press = std::string(GUDGEON_SOURCE_DIR) + "/examples/nine_bar/nine_bar.toml";
  const Outcome outcome = run_program(folder, {"equilibrium", press});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("The clearance joints A, B are taken as ideal.\n"));
  EXPECT_THAT(outcome.out, HasSubstr("No degree of freedom is left: the drivers hold it."));
  EXPECT_THAT(outcome.out, ContainsRegex("crank_1 +[0-9.]+ mN m"));
}

}  // namespace
}  // namespace gudgeon::test
