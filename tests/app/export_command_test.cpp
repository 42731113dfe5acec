// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon export with each of its options, through the program.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> split_at(const std::string& text, char end) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, end);) parts.push_back(part);
  return parts;
}

class ExportCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const Outcome run = run_program(*folder_, {"run", find_slider_crank(), "--quiet", "-o", "runs", "--set",
                                               "study.cycles=1", "--set", "study.outputs_per_cycle=100"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static Outcome run_export(const std::string& directory, std::vector<std::string> options) {
    std::vector<std::string> arguments{"export", "runs/base.h5", "-o", directory};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(*folder_, arguments);
  }
  /// The rows of one file, the first the headings.
  static std::vector<std::string> export_rows(const std::string& file, const std::vector<std::string>& options) {
    const std::string directory = fmt::format("csv_{}", n_exports_++);
    const Outcome outcome = run_export(directory, options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return split_at(read_text(folder_->path() / directory / file), '\n');
  }
  static std::set<std::string> list_files(const std::string& directory) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_->path() / directory)) {
      names.insert(entry.path().filename());
    }
    return names;
  }

  static TemporaryFolder* folder_;
  static int n_exports_;
};

TemporaryFolder* ExportCommand::folder_ = nullptr;
int ExportCommand::n_exports_ = 0;

TEST_F(ExportCommand, WritesOnlyTheChannelsAskedFor) {
  const auto rows = export_rows("no_wear_channels.csv", {"--channel", "pin.normal_force", "--channel", "slider.x*"});
  EXPECT_EQ(rows[0],
            "time [s],slider.x [m],slider.x_velocity [m/s],slider.x_acceleration [m/s^2],pin.normal_force [N]");
  EXPECT_EQ(export_rows("no_wear_statistics.csv", {"--channel", "slider.x*"}).size(), 1U + 3U);
  const Outcome vain = run_export("vain", {"--channel", "slider.*", "--channel", "piston.*"});
  EXPECT_EQ(vain.exit_code, 2);
  EXPECT_THAT(vain.err, HasSubstr("--channel piston.*: no channel has such a name"));
  EXPECT_FALSE(std::filesystem::exists(folder_->path() / "vain"));
}

TEST_F(ExportCommand, WritesOnlyTheStagesAskedFor) {
  ASSERT_EQ(run_export("stages", {"--stage", "ideal"}).exit_code, 0);
  EXPECT_THAT(list_files("stages"), ElementsAre("ideal_channels.csv", "ideal_energy.csv", "ideal_statistics.csv"));
  const Outcome vain = run_export("vain", {"--stage", "wear_7"});
  EXPECT_EQ(vain.exit_code, 2);
  EXPECT_THAT(vain.err, HasSubstr("--stage wear_7: unknown stage; possible: ideal, no_wear, wear_1"));
}

TEST_F(ExportCommand, WritesOneSampleOfSoMany) {
  const auto all = export_rows("ideal_channels.csv", {"--channel", "crank.angle"});
  const auto some = export_rows("ideal_channels.csv", {"--channel", "crank.angle", "--every", "25"});
  ASSERT_EQ(all.size(), 1U + 101U);
  EXPECT_THAT(some, ElementsAre(all[0], all[1], all[26], all[51], all[76], all[101]));
  EXPECT_EQ(run_export("vain", {"--every", "0"}).exit_code, 2);
}

TEST_F(ExportCommand, WritesOtherUnits) {
  const std::vector<std::string> channels{"--channel", "slider.x", "--channel", "crank.angle"};
  const auto si = export_rows("ideal_channels.csv", channels);
  std::vector<std::string> options = channels;
  options.insert(options.end(), {"--unit", "mm", "--unit", "deg"});
  const auto other = export_rows("ideal_channels.csv", options);
  EXPECT_EQ(si[0], "time [s],crank.angle [rad],slider.x [m]");
  EXPECT_EQ(other[0], "time [s],crank.angle [deg],slider.x [mm]");
  ASSERT_EQ(si.size(), other.size());
  for (std::size_t i = 1; i < si.size(); ++i) {
    const auto in_si = split_at(si[i], ',');
    const auto in_other = split_at(other[i], ',');
    EXPECT_EQ(in_si[0], in_other[0]);
    EXPECT_NEAR(std::stod(in_other[1]), 57.29577951308232 * std::stod(in_si[1]), 1e-12);
    EXPECT_NEAR(std::stod(in_other[2]), 1e3 * std::stod(in_si[2]), 1e-12);
  }
}

TEST_F(ExportCommand, RefusesUnitsAskedForInVain) {
  const Outcome vain = run_export("vain", {"--unit", "kg"});
  EXPECT_EQ(vain.exit_code, 2);
  EXPECT_THAT(vain.err, HasSubstr("--unit kg: no column is of its dimension; in SI there are "));
  EXPECT_EQ(run_export("vain", {"--stage", "ideal", "--channel", "crank.angle", "--unit", "mm"}).exit_code, 2);
  const Outcome twice = run_export("vain", {"--unit", "mm", "--unit", "km"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.err, HasSubstr("--unit km: --unit mm is of the same dimension; give one of them"));
  EXPECT_EQ(run_export("vain", {"--unit", "furlong"}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_->path() / "vain"));
}

TEST_F(ExportCommand, WritesDecimalCommas) {
  const auto point = export_rows("ideal_channels.csv", {"--channel", "slider.x"});
  auto comma = export_rows("ideal_channels.csv", {"--channel", "slider.x", "--decimal-comma"});
  ASSERT_EQ(point.size(), comma.size());
  for (std::size_t i = 0; i < comma.size(); ++i) {
    if (i > 0) std::ranges::replace(comma[i], ',', '.');
    std::ranges::replace(comma[i], ';', ',');
    EXPECT_EQ(comma[i], point[i]);
  }
  EXPECT_THAT(comma[0], StartsWith("time [s],"));
}

TEST_F(ExportCommand, ReplacesFilesOnlyWhenTold) {
  ASSERT_EQ(run_export("twice", {"--stage", "ideal"}).exit_code, 0);
  folder_->write("twice/ideal_energy.csv", "precious");
  const Outcome again = run_export("twice", {"--stage", "ideal"});
  EXPECT_EQ(again.exit_code, 5);
  EXPECT_EQ(read_text(folder_->path() / "twice" / "ideal_energy.csv"), "precious");
  EXPECT_EQ(run_export("twice", {"--stage", "ideal", "--overwrite"}).exit_code, 0);
  EXPECT_THAT(read_text(folder_->path() / "twice" / "ideal_energy.csv"), StartsWith("value [J],term"));
}

}  // namespace
}  // namespace gudgeon::test
