// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The order of what the program writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;

// A crank that is too long to turn: the coupler and the rocker reach 180 mm from O2, the crank's end goes 300 mm away.
constexpr const char* kTooLong = R"(
name = "too_long"
bodies.frame.points = { O1 = [0, 0], O2 = ["200 mm", 0] }
bodies.crank = { mass = 1, inertia = 1e-3, points = { O = [0, 0], A = ["100 mm", 0] } }
bodies.rocker = { mass = 1, inertia = 1e-3, points = { O = [0, 0], B = ["80 mm", 0] }, start = { angle = "130 deg" } }
bodies.rod = { mass = 1, inertia = 1e-3, points = { A = [0, 0], B = ["100 mm", 0] }, start = { angle = "50 deg" } }
joints.O1 = { type = "revolute", between = ["frame.O1", "crank.O"] }
joints.O2 = { type = "revolute", between = ["frame.O2", "rocker.O"] }
joints.A = { type = "revolute", between = ["crank.A", "rod.A"] }
joints.B = { type = "revolute", between = ["rod.B", "rocker.B"] }
drivers.crank = { body = "crank", speed = "60 rpm" }
)";

// Also where both streams go into one file, as behind a pipe or in a log.
TEST(TextOutput, AnErrorComesAfterWhatWasPrintedBefore) {
  const TemporaryFolder folder;
  folder.write("too_long.toml", kTooLong);
  const std::filesystem::path log = folder.path() / "log.txt";
  const Outcome outcome = RunningProgram(folder, {"kinematics", "too_long.toml"}, log, log).wait();
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("gudgeon: E-NUM-010"));
  EXPECT_LT(outcome.err.find("too_long"), outcome.err.find("gudgeon: E-NUM-010"));
}

}  // namespace
}  // namespace gudgeon::test
