// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Run files whose parts are each sound, and do not belong together: something was taken out, or put in twice.
#include "gudgeon/io/run_verifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>

#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/run_reader.h"
#include "tests/io/scratch_directory.h"
#include "tests/io/written_run.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using test::ScratchDirectory;
using testing::ElementsAre;
using testing::HasSubstr;

/// With statistics of every channel, as runs have them.
RunRecord make_complete_run() {
  RunRecord run = test::make_run();
  for (StageRecord& stage : run.stages) {
    for (const Channel& channel : stage.channels) {
      if (find_statistics(stage, channel.name) == nullptr) stage.statistics.push_back({channel.name});
    }
  }
  return run;
}

/// What verification finds in a run file that another hand changed with HDF5 itself.
std::vector<std::string> verify_spoiled(const std::function<void(const Hdf5Handle& root)>& change,
                                        const RunRecord& run = make_complete_run()) {
  const ScratchDirectory scratch;
  test::write_run(scratch / "x.h5", run);
  {
    const Hdf5Session session;
    const Hdf5Handle file =
        check_id(H5Fopen((scratch / "x.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "cannot open", "x.h5");
    change(open_root(file));
  }
  return verify_run(scratch / "x.h5").errors;
}

Hdf5Handle open_worn_stage(const Hdf5Handle& root) { return open_group(open_group(root, "stages"), "wear_1"); }
Hdf5Handle open_worn_channels(const Hdf5Handle& root) { return open_group(open_worn_stage(root), "channels"); }

void link_again(const Hdf5Handle& from, const char* name, const Hdf5Handle& to, const char* other) {
  check_status(H5Lcreate_hard(from.id(), name, to.id(), other, H5P_DEFAULT, H5P_DEFAULT), "cannot link", other);
}

TEST(RunVerifier, FindsNothingWrongWithAWholeRun) {
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle&) {}), testing::IsEmpty());
}

TEST(RunVerifier, MissesAChannelThatWasTakenOut) {
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) {
                remove_link(open_group(open_worn_channels(root), "slider"), "x_velocity");
              }),
              ElementsAre("/stages/wear_1/statistics: its channel 'slider.x_velocity' is missing"));
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) {
                remove_link(open_group(open_worn_channels(root), "A"), "normal_force");
              }),
              ElementsAre("/stages/wear_1/statistics: its channel 'A.normal_force' is missing",
                          "/stages/wear_1/channels/A: it has no channel"));
}

TEST(RunVerifier, SeesAChannelWithoutStatistics) {
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) {
                const Hdf5Handle series =
                    write_series(open_worn_channels(root), "added", std::vector<double>(test::kSamples));
                write_text_attribute(series, "symbol", "a");
                write_text_attribute(series, "description", "of another hand");
              }),
              ElementsAre("/stages/wear_1/statistics: it has no row of channel 'added'"));
}

TEST(RunVerifier, SeesOneDatasetUnderTwoNames) {
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) {
                const Hdf5Handle slider = open_group(open_worn_channels(root), "slider");
                remove_link(slider, "x_velocity");
                link_again(slider, "x", slider, "x_velocity");
              }),
              ElementsAre("/stages/wear_1/channels/slider/x_velocity: it is /stages/wear_1/channels/slider/x under "
                          "another name, too"));
  // Of another stage.
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) {
                const Hdf5Handle wear = open_group(open_group(open_worn_stage(root), "wear"), "A");
                const Hdf5Handle before =
                    open_group(open_group(open_group(open_group(root, "stages"), "no_wear"), "wear"), "A");
                remove_link(wear, "bearing_depth");
                link_again(before, "bearing_depth", wear, "bearing_depth");
              }),
              ElementsAre("/stages/wear_1/wear/A/bearing_depth: it is /stages/no_wear/wear/A/bearing_depth under "
                          "another name, too"));
}

TEST(RunVerifier, SeesATimeThatIsNotTheStages) {
  EXPECT_THAT(verify_spoiled(
                  [](const Hdf5Handle& root) { remove_link(open_group(open_worn_channels(root), "slider"), "time"); }),
              ElementsAre("/stages/wear_1/channels/slider: its 'time' is missing, or is not that of the stage"));
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) {
                const Hdf5Handle slider = open_group(open_worn_channels(root), "slider");
                remove_link(slider, "time");
                write_series(slider, "time", std::vector<double>(test::kSamples));
              }),
              ElementsAre("/stages/wear_1/channels/slider: its 'time' is missing, or is not that of the stage"));
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) {
                const Hdf5Handle slider = open_group(open_worn_channels(root), "slider");
                remove_link(slider, "time");
                link_again(open_group(open_worn_channels(root), "crank"), "angle_rate", slider, "time");
              }),
              testing::Contains(HasSubstr("channels/slider: its 'time' is missing, or is not that of the stage")));
}

TEST(RunVerifier, SeesStagesThatDoNotFollowEachOther) {
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) { remove_link(open_group(root, "stages"), "no_wear"); }),
              ElementsAre("/stages: stage 'wear_1' stands where 'no_wear' belongs"));
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) { remove_link(open_group(root, "stages"), "wear_1"); }),
              testing::IsEmpty());  // as after a kill
}

TEST(RunVerifier, ComparesTheFailureWithTheStages) {
  RunRecord failed = make_complete_run();
  failed.stages.back().status = StageStatus::failed;
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle&) {}, failed), testing::IsEmpty());
  EXPECT_THAT(verify_spoiled([](const Hdf5Handle& root) { remove_link(root, "failure"); }, failed),
              ElementsAre("/failure: it is missing: stage 'wear_1' failed"));
  EXPECT_THAT(verify_spoiled(
                  [](const Hdf5Handle& root) {
                    const Hdf5Handle stage = open_worn_stage(root);
                    remove_link(stage, "status");
                    write_text(stage, "status", "finished");
                  },
                  failed),
              ElementsAre("/failure: no stage failed"));
}

}  // namespace
}  // namespace gudgeon
