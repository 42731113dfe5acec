// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Curves and formulas through the whole program: what a load does between its points, and what check says of motions.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// One column of a CSV file with a line of names.
std::vector<double> read_column(const std::filesystem::path& file, const std::string& name) {
  std::istringstream lines(read_text(file));
  std::string line;
  std::getline(lines, line);
  std::istringstream names(line);
  std::string word;
  int column = -1;
  for (int k = 0; std::getline(names, word, ','); ++k) {
    if (word.starts_with(name)) column = k;
  }
  std::vector<double> values;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (int k = 0; k <= column; ++k) std::getline(cells, word, ',');
    values.push_back(std::stod(word));
  }
  return values;
}

TEST(Curves, KeepTheShapeOfALoadsPoints) {
  const TemporaryFolder folder;
  const Outcome run = run_program(folder, {"run", find_case("curve_overshoot"), "-o", "out"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out + run.err, HasSubstr("W-MODEL-115"));
  EXPECT_THAT(run.out, HasSubstr("work of forces and torques    118.0 J"));  // counted as given away
  const Outcome written = run_program(folder, {"export", "out/base.h5", "-o", "csv"});
  ASSERT_EQ(written.exit_code, 0) << written.err << written.out;
  const std::vector<double> force = read_column(folder.path() / "csv/ideal_channels.csv", "punch.x_force");
  ASSERT_FALSE(force.empty());
  EXPECT_NEAR(std::ranges::min(force), -40e3, 1e-9);
  EXPECT_NEAR(std::ranges::max(force), 0.0, 1e-9);
}

TEST(Curves, AreDrawnByCheckAndInTheReport) {
  const TemporaryFolder folder;
  const Outcome check = run_program(folder, {"check", find_case("curve_overshoot"), "--plots", "curves"});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("loads.punch.force.0.over.G.displacement.svg"));
  EXPECT_THAT(read_text(folder.path() / "curves/loads.punch.force.0.over.G.displacement.svg"),
              HasSubstr("force in x over G.displacement"));
  // A second time only where it is asked for.
  EXPECT_EQ(run_program(folder, {"check", find_case("curve_overshoot"), "--plots", "curves"}).exit_code, 5);
  ASSERT_EQ(run_program(folder, {"run", find_case("curve_overshoot"), "-o", "out"}).exit_code, 0);
  ASSERT_EQ(run_program(folder, {"report", "out"}).exit_code, 0);
  EXPECT_THAT(read_text(folder.path() / "out/report.html"), HasSubstr("Loads and motions as they were given"));
  EXPECT_THAT(run_program(folder, {"plot", "out", "--list"}).out,
              HasSubstr("base.loads.punch.force.0.over.G.displacement"));
}

TEST(Curves, TellWhereASplineOvershoots) {
  const TemporaryFolder folder;
  std::string text = read_text(find_case("curve_overshoot"));
  const std::string key = "value_unit = \"kN\"";
  text.insert(text.find(key) + key.size(), ", interpolation = \"spline\"");
  const std::string file = folder.write("punch.toml", text).filename();
  const Outcome outcome = run_program(folder, {"check", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("R-MODEL-116"));
  EXPECT_THAT(outcome.out, HasSubstr("between points 5 and 6 the spline leaves their range, 0 N to 0 N, by 5.9"));
}

TEST(Curves, RefuseAMotionThatJumpsLate) {
  const TemporaryFolder folder;
  for (const char* command : {"check", "run"}) {
    const Outcome outcome = run_program(folder, {command, find_case("late_jump")});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("E-MODEL-062"));
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("it jumps by 0.3 rad at t = 2.5 s"));
  }
}

/// A crank that an encoder of 10 000 counts saw speed up with 5 rad/s², 2000 samples at 1 kHz.
std::string make_measured(const std::string& smoothing) {
  const double count = 2.0 * std::numbers::pi / 10000.0;
  std::string times;
  std::string angles;
  for (int k = 0; k < 2000; ++k) {
    const double t = 1e-3 * k;
    times += fmt::format("{}{}", k == 0 ? "" : ", ", t);
    angles += fmt::format("{}{:.9f}", k == 0 ? "" : ", ", count * std::round((3.0 * t + 2.5 * t * t) / count));
  }
  return fmt::format(R"toml(name = "measured"
[bodies.frame]
points = {{ O = [0, 0] }}
[bodies.crank]
mass = "2 kg"
inertia = "0.01 kg m^2"
points = {{ O = [0, 0] }}
[joints.O]
type = "revolute"
between = ["frame.O", "crank.O"]
[drivers.d]
body = "crank"
motion = {{ arguments = [{}], values = [{}]{} }}
[study]
cycle_time = "1.9 s"
cycles = 1
)toml",
                     times, angles, smoothing);
}

TEST(Curves, TellTheNoiseOfAMeasuredMotion) {
  const TemporaryFolder folder;
  const std::string file = folder.write("measured.toml", make_measured("")).filename();
  const Outcome outcome = run_program(folder, {"check", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("W-MODEL-117"));
  EXPECT_THAT(outcome.out, HasSubstr("rad/s^2 that are left without it"));
  const std::string smooth = folder.write("smooth.toml", make_measured(", smoothing = \"2 Hz\"")).filename();
  const Outcome smoothed = run_program(folder, {"check", smooth});
  EXPECT_EQ(smoothed.exit_code, 0) << smoothed.err;
  EXPECT_THAT(smoothed.out, Not(HasSubstr("W-MODEL-117")));
}

}  // namespace
}  // namespace gudgeon::test
