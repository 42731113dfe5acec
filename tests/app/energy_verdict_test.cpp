// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The verdict on a run's energy, in the exit code and wherever a run is shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Stiff steps are not held to the energy balance: at 1e-2 they miss a hundred times more than is allowed.
constexpr const char* kSwing = R"toml(
name = "swing"
gravity = [0, "-9.81 m/s^2"]
bodies.frame.points = { O1 = [0, 0], O2 = ["200 mm", 0] }
bodies.crank = { mass = 1, inertia = 1e-3, points = { O = [0, 0], A = ["60 mm", 0] }, start = { angle = "60 deg" } }
bodies.rod = { mass = 1, inertia = 2e-3, points = { A = [0, 0], B = ["180 mm", 0] }, start = { angle = "10 deg" } }
bodies.rocker = { mass = 1, inertia = 1e-3, points = { O = [0, 0], B = ["110 mm", 0] }, start = { angle = "80 deg" } }
joints.O1 = { type = "revolute", between = ["frame.O1", "crank.O"] }
joints.O2 = { type = "revolute", between = ["frame.O2", "rocker.O"] }
joints.A = { type = "revolute", between = ["crank.A", "rod.A"] }
joints.B = { type = "revolute", between = ["rod.B", "rocker.B"] }
loads.push = { type = "torque", body = "crank", torque = "1e-3*sqrt(limit - t)", constants = { limit = 9 } }
[study]
cycle_time = 1
cycles = 5
integrator = "stiff"
relative_tolerance = 1e-2
[cases.tight]
set = { "study.relative_tolerance" = 1e-6, "study.integrator" = "automatic" }
[cases.broken]
set = { "loads.push.constants.limit" = 0.5 }
)toml";

TEST(EnergyVerdict, AnEnergyBalanceThatDoesNotCloseEndsWith6AndIsShownEverywhere) {
  const TemporaryFolder folder;
  folder.write("swing.toml", kSwing);
  const Outcome first = run_program(folder, {"run", "swing.toml", "-o", "out", "--report"});
  EXPECT_EQ(first.exit_code, 6) << first.err;
  EXPECT_THAT(first.out, HasSubstr("NO\n"));
  EXPECT_THAT(first.err, HasSubstr("E-NUM-020: its energy balance does not close"));
  EXPECT_THAT(first.err, HasSubstr("study.relative_tolerance"));
  EXPECT_THAT(first.err, Not(HasSubstr("what was finished is kept"))) << "all of it is";
  EXPECT_THAT(read_text(folder.path() / "out" / "report.html"), HasSubstr("E-NUM-020"));

  // What an earlier run finished is judged again.
  const Outcome resumed = run_program(folder, {"run", "swing.toml", "-o", "out", "--resume", "--quiet"});
  EXPECT_EQ(resumed.exit_code, 6);
  EXPECT_THAT(resumed.err, HasSubstr("E-NUM-020"));

  // Showing a run is not running it.
  const Outcome info = run_program(folder, {"info", "out/base.h5"});
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_THAT(info.out, HasSubstr("E-NUM-020"));
  EXPECT_EQ(run_program(folder, {"export", "out/base.h5", "-o", "csv"}).exit_code, 0);
  EXPECT_THAT(read_text(folder.path() / "csv" / "ideal_energy.csv"), HasSubstr(",allowed_residual"));
}

TEST(EnergyVerdict, OneCaseOfSeveralIsEnough) {
  const TemporaryFolder folder;
  folder.write("swing.toml", kSwing);
  const auto run = [&](std::initializer_list<std::string> cases) {
    std::vector<std::string> arguments{"run", "swing.toml", "--overwrite"};
    for (const std::string& name : cases) arguments.insert(arguments.end(), {"--case", name});
    return run_program(folder, arguments);
  };
  EXPECT_EQ(run({"tight"}).exit_code, 0);
  EXPECT_EQ(run({"tight", "base"}).exit_code, 6);
  // A case that could not go on counts more.
  const Outcome worse = run({"base", "broken"});
  EXPECT_EQ(worse.exit_code, 4);
  EXPECT_THAT(worse.err, HasSubstr("case base: stage ideal: E-NUM-020"));
  EXPECT_THAT(worse.err, HasSubstr("case broken: stage ideal: E-NUM-003"));
}

// A bearing that knocks, at a tolerance of 1e-3: whatever the verdict, the exit code agrees with it.
TEST(EnergyVerdict, TheExitCodeSaysWhatTheSummarySays) {
  const TemporaryFolder folder;
  for (const char* tolerance : {"1e-3", "1e-6"}) {
    const Outcome outcome = run_program(folder, {"run", find_case("energy_loose_tolerance"), "--overwrite", "--set",
                                                 std::string("study.relative_tolerance=") + tolerance});
    const bool adds_up = outcome.out.find("NO\n") == std::string::npos;
    EXPECT_EQ(outcome.exit_code, adds_up ? 0 : 6) << outcome.err;
  }
}

// 2 nJ beside 89 mJ of kinetic energy.
TEST(EnergyVerdict, IsNotSaidWhereNextToNothingIsExchanged) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"run", find_case("energy_nothing_exchanged")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("balanced"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("NO\n")));
}

TEST(EnergyVerdict, IsInTheHelp) {
  const TemporaryFolder folder;
  EXPECT_THAT(run_program(folder, {"--help"}).out, HasSubstr("6 finished, but an energy balance does not close"));
}

}  // namespace
}  // namespace gudgeon::test
