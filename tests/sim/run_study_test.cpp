// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stages in their order, on the surfaces that those before them left.
#include "gudgeon/sim/run_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <tuple>

#include "gudgeon/base/diagnostics.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using testing::ElementsAre;

Study make_study(int wear_stages) {
  Study study;
  study.cycle_time = 0.1;
  study.cycles = 1;
  study.outputs_per_cycle = 20;
  study.wear_stages = wear_stages;
  study.wear_acceleration = 1e5;
  study.cells = 200;
  return study;
}

std::vector<std::string> find_names(const std::vector<StageRecord>& stages) {
  std::vector<std::string> names;
  for (const StageRecord& stage : stages) names.push_back(stage.name);
  return names;
}

TEST(RunStudy, StagesHaveTheirNamesInOrder) {
  const Mechanism press = oracle::make_nine_bar();
  EXPECT_THAT(find_names(run_study(press, make_study(0))), ElementsAre("ideal", "no_wear"));
  EXPECT_THAT(find_names(run_study(press, make_study(2))), ElementsAre("ideal", "no_wear", "wear_1", "wear_2"));
  Study study = make_study(1);
  study.compare_ideal = false;
  EXPECT_THAT(find_names(run_study(press, study)), ElementsAre("no_wear", "wear_1"));
}

TEST(RunStudy, WithoutClearanceThereIsOnlyTheIdealStage) {
  for (const bool compare_ideal : {true, false}) {
    Study study = make_study(3);
    study.compare_ideal = compare_ideal;
    const auto stages = run_study(oracle::make_four_bar(), study);
    ASSERT_THAT(find_names(stages), ElementsAre("ideal"));
    EXPECT_EQ(stages[0].status, StageStatus::finished);
    EXPECT_TRUE(stages[0].wear.empty());
  }
}

TEST(RunStudy, EveryStageRunsOnWhatTheOneBeforeLeft) {
  const auto stages = run_study(oracle::make_nine_bar(), make_study(2));
  ASSERT_EQ(stages.size(), 4U);
  EXPECT_TRUE(stages[0].wear.empty()) << "ideal";
  for (std::size_t joint = 0; joint < 2; ++joint) {
    EXPECT_THAT(stages[1].wear.at(joint).bearing_depth, testing::Each(0.0));
    for (std::size_t s = 1; s < 3; ++s) {
      const JointWear& before = stages[s].wear.at(joint);
      const JointWear& after = stages[s + 1].wear.at(joint);
      EXPECT_GT(before.removed_volume, 0.0);
      ASSERT_EQ(after.bearing_depth.size(), 200U);
      for (std::size_t k = 0; k < 200; ++k) {
        EXPECT_EQ(after.bearing_depth[k], before.bearing_depth[k] + before.bearing_depth_added[k]);
        EXPECT_EQ(after.journal_depth[k], before.journal_depth[k] + before.journal_depth_added[k]);
      }
    }
  }
  // And feels them: the same joints, other forces.
  EXPECT_NE(*find_values(stages[1], "A.normal_force"), *find_values(stages[2], "A.normal_force"));
  EXPECT_EQ(find_values(stages[1], "rod_2.angle")->front(), find_values(stages[3], "rod_2.angle")->front())
      << "each starts from the assembled position";
}

// A law that runs in over 1 km: slid a centimetre a stage, accelerated twenty million times, the second stage is past
// it and wears as one without running in, the first is not. Depths are far too small to change the motion.
TEST(RunStudy, TheDistanceSlidGoesOnAccelerated) {
  Study study = make_study(1);
  study.wear_acceleration = 2e7;
  study.compare_ideal = false;
  const auto run_with = [&](const AnyWear& wear) {
    Mechanism press = oracle::make_nine_bar();
    for (Joint& joint : press.joints) {
      if (auto* pin = std::get_if<RevoluteClearance>(&joint.kind)) {
        pin->contact.bearing_wear = wear;
        pin->contact.journal_wear = NoWear{};
      }
    }
    return run_study(press, study);
  };
  const auto running_in = run_with(RunningInDistance{9e-30, 1e-30, 1000.0});
  const auto worn_in = run_with(Archard{1e-30});
  for (std::size_t joint = 0; joint < 2; ++joint) {
    const double slid = 2e7 * worn_in[0].wear[joint].sliding_distance;
    ASSERT_GT(slid, 1e4) << "ten times the distance of running in";
    ASSERT_LT(slid / 2e7, 10.0) << "a hundredth of it, had it not been accelerated";
    // Surfaces that differ by less than an atom let chaotic contacts part by some tenths of a percent.
    EXPECT_NEAR(running_in[1].wear[joint].archard_volume / worn_in[1].wear[joint].archard_volume, 1.0, 0.01);
    // The first: F constant would give 1 + 8 s_r/s (1 − exp(−s/s_r)).
    EXPECT_GT(running_in[0].wear[joint].archard_volume / worn_in[0].wear[joint].archard_volume, 1.02);
  }
}

TEST(RunStudy, CallsItsHooks) {
  std::vector<std::string> finished;
  std::vector<std::tuple<int, std::string, double>> progress;
  RunHooks hooks;
  hooks.stage_finished = [&](const StageRecord& stage) { finished.push_back(stage.name); };
  hooks.progress = [&](const Progress& at) {
    EXPECT_EQ(at.n_stages, 3);
    EXPECT_EQ(static_cast<std::size_t>(at.stage_index), finished.size()) << "stages before are handed over already";
    progress.emplace_back(at.stage_index, std::string{at.stage}, at.fraction);
  };
  const auto stages = run_study(oracle::make_nine_bar(), make_study(1), hooks);
  EXPECT_THAT(finished, ElementsAre("ideal", "no_wear", "wear_1"));
  EXPECT_EQ(find_names(stages), finished);
  EXPECT_TRUE(std::ranges::is_sorted(progress, {}, [](const auto& p) { return std::get<0>(p) + std::get<2>(p); }));
  for (int index = 0; index < 3; ++index) {
    const std::tuple begins{index, finished[index], 0.0};
    const std::tuple ends{index, finished[index], 1.0};
    EXPECT_EQ(std::ranges::count(progress, begins), 1) << index;
    EXPECT_EQ(std::ranges::count(progress, ends), 1) << index;
  }
}

TEST(RunStudy, AStoppedStageEndsTheRunAndIsHandedOver) {
  std::stop_source source;
  std::vector<StageStatus> finished;
  RunHooks hooks;
  hooks.stop = source.get_token();
  hooks.progress = [&](const Progress& at) {
    if (at.stage == "no_wear" && at.fraction > 0.5) source.request_stop();
  };
  hooks.stage_finished = [&](const StageRecord& stage) { finished.push_back(stage.status); };
  const auto stages = run_study(oracle::make_nine_bar(), make_study(2), hooks);
  EXPECT_THAT(find_names(stages), ElementsAre("ideal", "no_wear"));
  EXPECT_THAT(finished, ElementsAre(StageStatus::finished, StageStatus::stopped));
}

// What an earlier run finished is taken over; the rest has the same bits as in one go.
TEST(RunStudy, GoesOnAfterFinishedStages) {
  const auto whole = run_study(oracle::make_nine_bar(), make_study(1));
  std::vector<std::string> run_again;
  RunHooks hooks;
  hooks.stage_finished = [&](const StageRecord& stage) { run_again.push_back(stage.name); };
  const auto rest = run_study(oracle::make_nine_bar(), make_study(1), hooks, {whole[0], whole[1]});
  EXPECT_THAT(run_again, ElementsAre("wear_1"));
  ASSERT_EQ(find_names(rest), find_names(whole));
  for (std::size_t s = 0; s < whole.size(); ++s) EXPECT_EQ(rest[s].values, whole[s].values) << s;
}

void add_samples(StageRecord& stage, std::span<const double> time, std::span<const std::vector<double>> values) {
  stage.values.resize(values.size());
  stage.time.insert(stage.time.end(), time.begin(), time.end());
  for (std::size_t k = 0; k < values.size(); ++k) {
    stage.values[k].insert(stage.values[k].end(), values[k].begin(), values[k].end());
  }
}

// Each block comes in the memory of the one before.
TEST(RunStudy, BlocksTakeNoNewMemory) {
  std::map<std::string, std::vector<const double*>> places;
  RunHooks hooks;
  hooks.samples_per_block = 5;
  hooks.samples = [&](const SampleBlock& block) {
    std::vector<const double*> now{block.time.data()};
    for (const std::vector<double>& values : block.values) now.push_back(values.data());
    EXPECT_EQ(places.emplace(block.stage, now).first->second, now);
  };
  run_study(oracle::make_nine_bar(), make_study(1), hooks);
  EXPECT_EQ(places.size(), 3U);
}

// One sample a block, some, all but the last, exactly all, more than there are.
TEST(RunStudy, BlocksJoinedAreTheSamplesThatAreKept) {
  const Study study = make_study(1);
  const auto whole = run_study(oracle::make_nine_bar(), study);
  const std::size_t n_samples = whole[0].time.size();
  for (const std::size_t size : {std::size_t{1}, std::size_t{5}, n_samples - 1, n_samples, n_samples + 1}) {
    std::vector<StageRecord> joined;
    bool is_under_way = false;
    RunHooks hooks;
    hooks.samples_per_block = size;
    hooks.samples = [&](const SampleBlock& block) {
      if (!is_under_way) joined.emplace_back().name = block.stage;
      is_under_way = true;
      EXPECT_EQ(block.stage, joined.back().name);
      EXPECT_EQ(block.channels.size(), whole[joined.size() - 1].channels.size());
      EXPECT_EQ(block.time.size(), size);
      add_samples(joined.back(), block.time, block.values);
    };
    hooks.stage_finished = [&](const StageRecord& stage) {
      if (!is_under_way) joined.emplace_back().name = stage.name;
      is_under_way = false;
      EXPECT_LT(stage.time.size(), size);
      add_samples(joined.back(), stage.time, stage.values);
    };
    const auto left = run_study(oracle::make_nine_bar(), study, hooks);
    ASSERT_EQ(find_names(joined), find_names(whole));
    for (std::size_t s = 0; s < whole.size(); ++s) {
      EXPECT_EQ(joined[s].time, whole[s].time) << size;
      EXPECT_EQ(joined[s].values, whole[s].values) << size;
      EXPECT_EQ(left[s].statistics[0].rms, whole[s].statistics[0].rms);
      EXPECT_TRUE(left[s].time.empty());
      EXPECT_EQ(left[s].values, std::vector<std::vector<double>>(whole[s].channels.size()));
    }
  }
}

TEST(RunStudy, AWornThroughJournalEndsTheRunBeforeItsStage) {
  Study study = make_study(2);
  study.wear_acceleration = 1e9;
  const auto stages = run_study(oracle::make_nine_bar(), study);
  ASSERT_THAT(find_names(stages), ElementsAre("ideal", "no_wear", "wear_1"));
  EXPECT_EQ(stages[2].status, StageStatus::failed);
  EXPECT_THAT(stages[2].message, testing::AllOf(testing::HasSubstr("E-NUM-004"), testing::HasSubstr("joint 'A'"),
                                                testing::HasSubstr("study.wear_acceleration")));
}

TEST(RunStudy, AJournalBeyondItsBearingIsAnErrorOfTheModel) {
  Mechanism mechanism = oracle::make_free_body_in_bearing();
  mechanism.bodies[1].start.position = Vec2{0.3, 0.0};
  try {
    run_study(mechanism, make_study(0));
    FAIL() << "it cannot be outside";
  } catch (const ModelError& error) {
    ASSERT_EQ(error.diagnostics().items().size(), 1U);
    EXPECT_EQ(error.diagnostics().items()[0].code, "E-MODEL-074");
  }
}

TEST(RunStudy, ASingularStartIsAnErrorOfTheModel) {
  Mechanism mechanism = oracle::make_n_four_bar(2);
  for (Body& body : mechanism.bodies) {
    if (body.name.starts_with("post")) body.start = oracle::start_at(0.0);
  }
  bool called = false;
  RunHooks hooks;
  hooks.stage_finished = [&](const StageRecord&) { called = true; };
  try {
    run_study(mechanism, make_study(0), hooks);
    FAIL() << "the motion is not determined";
  } catch (const ModelError& error) {
    ASSERT_EQ(error.diagnostics().items().size(), 1U);
    EXPECT_EQ(error.diagnostics().items()[0].code, "E-MODEL-073");
  }
  EXPECT_FALSE(called);
}

// Neither what a stage runs on nor the stage is made.
TEST(RunStudy, AStopBetweenTwoStagesEndsBeforeTheNext) {
  std::stop_source source;
  std::vector<std::string> begun;
  RunHooks hooks;
  hooks.stop = source.get_token();
  hooks.progress = [&](const Progress& at) {
    if (at.fraction == 0.0) begun.emplace_back(at.stage);
  };
  hooks.stage_finished = [&](const StageRecord& stage) {
    if (stage.name == "no_wear") source.request_stop();
  };
  const auto stages = run_study(oracle::make_nine_bar(), make_study(2), hooks);
  EXPECT_THAT(begun, ElementsAre("ideal", "no_wear"));
  ASSERT_THAT(find_names(stages), ElementsAre("ideal", "no_wear", "wear_1"));
  EXPECT_EQ(stages[2].status, StageStatus::stopped);
  EXPECT_EQ(stages[2].message, "stopped on request before it began");
}

}  // namespace
}  // namespace gudgeon
