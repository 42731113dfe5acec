// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Run files of format 1 are still read. The file was written by a program of that time: a hammer on a worn pin.
#include <gtest/gtest.h>

#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_writer.h"
#include "tests/io/scratch_directory.h"
#include "tests/results/same_run.h"

namespace gudgeon {
namespace {

const char* const kFile = GUDGEON_SOURCE_DIR "/tests/io/files/format_1.h5";

// The values are what that program said of it.
TEST(FormatOne, IsReadWhole) {
  const RunRecord run = read_run(kFile);
  EXPECT_EQ(run.case_name, "base");
  EXPECT_EQ(run.model_text.substr(0, 15), "name = \"hammer\"");
  EXPECT_EQ(run.resolved_model.substr(0, 15), "name = \"hammer\"");
  ASSERT_EQ(run.overrides.size(), 1u);
  EXPECT_EQ(run.overrides[0], (std::pair<std::string, std::string>{"study.cycles", "2"}));
  ASSERT_EQ(run.stages.size(), 3u);
  EXPECT_EQ(run.stages[0].name, "ideal");
  EXPECT_EQ(run.stages[1].name, "no_wear");
  const StageRecord& worn = run.stages[2];
  EXPECT_EQ(worn.name, "wear_1");
  EXPECT_EQ(worn.cycles, 2);
  ASSERT_EQ(worn.time.size(), 11u);
  EXPECT_DOUBLE_EQ(worn.time.back(), 0.6);
  ASSERT_EQ(worn.channels.size(), 31u);
  EXPECT_EQ(worn.channels.front().name, "arm.x");
  EXPECT_EQ(worn.values.front().size(), worn.time.size());
  const ChannelStatistics* force = find_statistics(worn, "O.normal_force");
  ASSERT_NE(force, nullptr);
  EXPECT_NEAR(force->maximum, 204.6, 0.05);
  ASSERT_EQ(worn.wear.size(), 1u);
  EXPECT_EQ(worn.wear[0].bearing_depth.size(), 16u);
  EXPECT_NEAR(worn.wear[0].archard_volume, 0.03204e-9, 1e-14);
  EXPECT_EQ(worn.events.size(), 10u);
  EXPECT_NEAR(worn.energy.exchanged, 1.196, 5e-4);
  EXPECT_NEAR(worn.energy.residual(), -413.0e-9, 1e-10);
}

TEST(FormatOne, IsWrittenAnewWhenARunGoesOn) {
  const test::ScratchDirectory scratch;
  std::filesystem::copy_file(kFile, scratch / "x.h5");
  RunRecord old = read_run(kFile);
  const std::vector<std::string> kept{"ideal", "no_wear"};
  RunWriter writer(scratch / "x.h5", old, true, kept);
  old.stages.pop_back();
  EXPECT_EQ(test::RunBytes(read_run(scratch / "x.h5")).bytes(), test::RunBytes(old).bytes());
}

}  // namespace
}  // namespace gudgeon
