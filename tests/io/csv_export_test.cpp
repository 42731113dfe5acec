// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// CSV files: their columns, their numbers, their manners.
#include "gudgeon/io/csv_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "gudgeon/base/diagnostics.h"
#include "tests/io/scratch_directory.h"
#include "tests/results/same_bits.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using test::make_run;
using test::read_text_file;
using test::ScratchDirectory;

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(CsvExport, WritesOneFileAStageAndKind) {
  const ScratchDirectory scratch;
  const auto written = export_csv(make_run(), scratch / "csv/deep", false);
  EXPECT_EQ(written.size(), 3u + 5u + 5u);  // the ideal stage has no joints
  for (const auto& path : written) EXPECT_TRUE(std::filesystem::exists(path)) << path;
  EXPECT_EQ(written.front(), scratch / "csv/deep/ideal_channels.csv");
}

TEST(CsvExport, ChannelsComeBackToTheLastBit) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  export_csv(run, scratch.path(), false);
  const auto lines = split_lines(read_text_file(scratch / "no_wear_channels.csv"));
  ASSERT_EQ(lines.size(), 1 + test::kSamples);
  EXPECT_EQ(lines[0],
            "time [s],slider.x [m],slider.x_velocity [m/s],slider.x_acceleration [m/s^2],slider.angle_rate [rad/s],"
            "crank.angle_rate [rad/s],crank.effort [N m],A.normal_force [N]");
  std::vector<double> x;
  for (std::size_t i = 1; i < lines.size(); ++i) x.push_back(std::stod(lines[i].substr(lines[i].find(',') + 1)));
  EXPECT_TRUE(test::have_same_bits(x, run.stages[1].values[0]));
}

TEST(CsvExport, WearHasTheMiddleOfEachCell) {
  const ScratchDirectory scratch;
  export_csv(make_run(), scratch.path(), false);
  const auto lines = split_lines(read_text_file(scratch / "no_wear_wear.csv"));
  ASSERT_EQ(lines.size(), 1 + test::kCells);
  EXPECT_EQ(lines[0],
            "surface,angle [rad],position [m],bearing_depth [m],journal_depth [m],bearing_depth_added "
            "[m],journal_depth_added [m],"
            "total_depth_added [m],joint");
  EXPECT_EQ(lines[1].substr(0, 23), "0,0.031415926535897934,");
  EXPECT_THAT(lines[98], testing::EndsWith(",4e-06,A"));
}

TEST(CsvExport, EventsStatisticsAndEnergy) {
  const ScratchDirectory scratch;
  RunRecord run = make_run();
  run.stages[1].wear[0].joint = "A, \"left\"";
  export_csv(run, scratch.path(), false);
  EXPECT_EQ(split_lines(read_text_file(scratch / "no_wear_events.csv"))[1],
            "0.05,0.5,0.12,-1,2000,0,0,\"A, \"\"left\"\"\"");
  EXPECT_EQ(split_lines(read_text_file(scratch / "no_wear_statistics.csv"))[4],
            "0,0,2000,0.05,20,120,A.normal_force,N");
  const auto energy = split_lines(read_text_file(scratch / "ideal_energy.csv"));
  EXPECT_EQ(energy[0], "value [J],term");
  EXPECT_EQ(energy[5], "12,driver_work");
  EXPECT_EQ(energy[6], "-2.5,load_work");
  EXPECT_EQ(energy[7], "1.75,damper_loss");
  EXPECT_EQ(energy[energy.size() - 2], "0,residual");
  EXPECT_THAT(energy.back(), testing::MatchesRegex("2.35.*,allowed_residual"));  // 1e-6 (23.25 + 0.2 · 1.5) J
}

TEST(CsvExport, UnitsDecimationAndDecimalComma) {
  const ScratchDirectory scratch;
  const CsvOptions options{100, {{"m", "mm", 1e-3}, {"N", "kN", 1e3}, {"J", "kJ", 1e3}}, true};
  export_csv(make_run(), scratch.path(), false, options);
  const auto channels = split_lines(read_text_file(scratch / "no_wear_channels.csv"));
  ASSERT_EQ(channels.size(), 1u + 3u);  // samples 0, 100 and 200
  EXPECT_THAT(channels[0], testing::StartsWith("time [s];slider.x [mm];slider.x_velocity [m/s];"));
  EXPECT_THAT(channels[1], testing::StartsWith("0;0,2;"));  // the lag of 0.2 mm
  EXPECT_THAT(channels[2], testing::StartsWith("1;"));
  EXPECT_EQ(split_lines(read_text_file(scratch / "no_wear_statistics.csv"))[4],
            "0;0;2;0,05;0,02;0,12;A.normal_force;kN");
  EXPECT_EQ(split_lines(read_text_file(scratch / "ideal_energy.csv"))[5], "0,012;driver_work");
  EXPECT_EQ(split_lines(read_text_file(scratch / "no_wear_events.csv"))[2], "0,7;0,005;0,3;2;1;-20;3;A");
}

// The list and the tables are written apart.
TEST(CsvExport, ListsTheUnitsOfItsColumns) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  std::set<std::string> units{"J"};  // a row each of the energies, with their unit beside them
  for (const auto& file : export_csv(run, scratch.path(), false)) {
    const std::string headings = split_lines(read_text_file(file))[0];
    for (auto at = headings.find('['); at != std::string::npos; at = headings.find('[', at + 1)) {
      units.insert(headings.substr(at + 1, headings.find(']', at) - at - 1));
    }
  }
  EXPECT_EQ(units, list_csv_units(run));
}

TEST(CsvExport, OutlineAndShortSeriesGiveEmptyCells) {
  const ScratchDirectory scratch;
  RunRecord run = make_run();
  run.stages.resize(2);
  run.stages[1].values[0].clear();
  run.stages[1].wear[0].bearing_depth.resize(1);
  export_csv(run, scratch.path(), false);
  const auto lines = split_lines(read_text_file(scratch / "no_wear_channels.csv"));
  EXPECT_THAT(lines[0], testing::StartsWith("time [s],slider.x_velocity [m/s],"));
  EXPECT_THAT(split_lines(read_text_file(scratch / "no_wear_wear.csv"))[2], testing::HasSubstr(",,0,"));
}

TEST(CsvExport, ReplacesOnlyWhenAskedAndThenWritesNothing) {
  const ScratchDirectory scratch;
  test::write_text_file(scratch / "wear_1_energy.csv", "precious");
  EXPECT_THROW(export_csv(make_run(), scratch.path(), false), FileError);
  EXPECT_FALSE(std::filesystem::exists(scratch / "ideal_channels.csv"));
  export_csv(make_run(), scratch.path(), true);
  EXPECT_NE(read_text_file(scratch / "wear_1_energy.csv"), "precious");
}

TEST(CsvExport, TellsWhenThereCanBeNoDirectory) {
  const ScratchDirectory scratch;
  test::write_text_file(scratch / "file", "");
  EXPECT_THROW(export_csv(make_run(), scratch / "file", false), FileError);
}

}  // namespace
}  // namespace gudgeon
