// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stages that go on from a checkpoint have the same bits as those that were never stopped.
#include "gudgeon/results/checkpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stop_token>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/state_archive.h"
#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"
#include "tests/results/same_bits.h"

namespace gudgeon {
namespace {

using test::have_same_bits;

// All numbers of a stage but the time that it took.
std::vector<double> list_numbers(const StageRecord& stage) {
  std::vector<double> all{stage.start_time, stage.end_time, stage.cycle_time, static_cast<double>(stage.cycles),
                          static_cast<double>(stage.status)};
  const auto add = [&](const std::vector<double>& values) { all.insert(all.end(), values.begin(), values.end()); };
  add(stage.time);
  for (const auto& values : stage.values) add(values);
  for (const ChannelStatistics& s : stage.statistics) {
    add({s.minimum, s.minimum_time, s.maximum, s.maximum_time, s.mean, s.rms});
  }
  for (const JointWear& w : stage.wear) {
    for (const auto* depths :
         {&w.bearing_depth, &w.journal_depth, &w.bearing_depth_added, &w.journal_depth_added, &w.total_depth_added}) {
      add(*depths);
    }
    add({w.archard_volume, w.removed_volume, w.sliding_distance, w.contact_time, w.impulse});
  }
  for (const ContactEvent& e : stage.events) {
    add({static_cast<double>(e.joint), e.onset_time, e.duration, e.onset_speed, e.angle, e.peak_force, e.position,
         static_cast<double>(e.contact)});
  }
  const EnergyBalance& l = stage.energy;
  add({l.initial_energy, l.kinetic, l.potential, l.elastic, l.driver_work, l.load_work, l.damper_loss,
       l.contact_damping, l.friction, l.surface_work, l.exchanged, l.load_reach});
  const SolverStatistics& s = stage.solver;
  for (const std::int64_t count :
       {s.evaluations, s.accepted_steps, s.rejected_steps, s.onsets, s.separations, s.projections}) {
    all.push_back(static_cast<double>(count));
  }
  add({s.smallest_step, s.largest_step, s.closure_residual});
  return all;
}

void expect_same(const std::vector<StageRecord>& one, const std::vector<StageRecord>& other, const std::string& what) {
  ASSERT_EQ(one.size(), other.size()) << what;
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].name, other[k].name) << what;
    EXPECT_EQ(one[k].message, other[k].message) << what;
    EXPECT_EQ(one[k].events.size(), other[k].events.size()) << what << ", " << one[k].name;
    EXPECT_EQ(one[k].solver.evaluations, other[k].solver.evaluations) << what << ", " << one[k].name;
    EXPECT_TRUE(have_same_bits(list_numbers(one[k]), list_numbers(other[k]))) << what << ", " << one[k].name;
  }
}

enum class When { after_every_step, a_hundred_times };

/// A study that runs through, with one in `stride` of its checkpoints.
struct WatchedRun {
  std::vector<StageRecord> stages;
  std::vector<Checkpoint> checkpoints;
  int n_offered = 0;
};

WatchedRun run_watched(const Mechanism& mechanism, const Study& study, int stride, When when = When::after_every_step) {
  WatchedRun run;
  std::atomic<bool> wanted = true;
  RunHooks hooks;
  hooks.checkpoint_wanted = &wanted;
  hooks.checkpoint = [&](const Checkpoint& checkpoint) {
    if (run.n_offered++ % stride == 0) run.checkpoints.push_back(checkpoint);
    wanted = when == When::after_every_step;
  };
  hooks.progress = [&](const Progress&) { wanted = true; };
  run.stages = run_study(mechanism, study, hooks);
  return run;
}

std::vector<StageRecord> resume_from(const Checkpoint& checkpoint, const Mechanism& mechanism, const Study& study,
                                     const std::vector<StageRecord>& whole, const RunHooks& hooks = {}) {
  std::vector<StageRecord> finished;
  for (const StageRecord& stage : whole) {
    if (stage.name == checkpoint.stage) break;
    finished.push_back(stage);
  }
  return run_study(mechanism, study, hooks, std::move(finished), checkpoint);
}

// Under sanitizers each takes ten times as long.
#ifdef GUDGEON_SANITIZE
constexpr int kFewer = 5;
#else
constexpr int kFewer = 1;
#endif

// Goes on from so many places all over the run.
void expect_same_from_everywhere(const Mechanism& mechanism, const Study& study, int least_offered = 50,
                                 int n_places = 10, When when = When::after_every_step) {
  const std::vector<StageRecord> whole = run_study(mechanism, study);
  const int n_all = run_watched(mechanism, study, 1 << 30, when).n_offered;
  ASSERT_GE(n_all, least_offered) << mechanism.name;
  const WatchedRun watched = run_watched(mechanism, study, std::max(1, n_all / std::max(1, n_places / kFewer)), when);
  expect_same(watched.stages, whole, mechanism.name + ": checkpoints change nothing");
  for (const Checkpoint& checkpoint : watched.checkpoints) {
    const std::string what = mechanism.name + " from " + checkpoint.stage + ", " + std::to_string(checkpoint.time);
    expect_same(resume_from(checkpoint, mechanism, study, whole), whole, what);
    if (testing::Test::HasFailure()) return;
  }
}

Study make_study(double cycle_time, int cycles, int wear_stages = 0) {
  Study study;
  study.cycle_time = cycle_time;
  study.cycles = cycles;
  study.outputs_per_cycle = 100;
  study.cells = 200;
  study.wear_stages = wear_stages;
  study.wear_acceleration = 1e5;
  study.compare_ideal = false;
  return study;
}

TEST(Checkpoints, OfEveryMechanismGoOnWithTheSameBits) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    expect_same_from_everywhere(mechanism, make_study(0.1, 1), 10, 4, When::a_hundred_times);
  }
}

TEST(Checkpoints, OfLoadedMechanismsGoOnWithTheSameBits) {
  for (const Mechanism& mechanism : oracle::make_loaded_mechanisms()) {
    expect_same_from_everywhere(mechanism, make_study(0.1, 1), 10, 4, When::a_hundred_times);
  }
}

TEST(Checkpoints, OfWornSurfacesAndOfWarmUpGoOnWithTheSameBits) {
  Study study = make_study(0.1, 1, 1);
  study.warm_up_cycles = 1;
  expect_same_from_everywhere(oracle::make_nine_bar(), study);
  study.wear_distribution = WearDistribution::point;
  expect_same_from_everywhere(oracle::make_slider_crank_guide(), study);
}

TEST(Checkpoints, OfEveryIntegratorGoOnWithTheSameBits) {
  for (const Integrator integrator : {Integrator::automatic, Integrator::explicit_pair, Integrator::stiff}) {
    Study study = make_study(0.1, 1);
    study.integrator = integrator;
    expect_same_from_everywhere(oracle::make_nine_bar(), study, 20);
    expect_same_from_everywhere(oracle::make_four_bar(), study, integrator == Integrator::stiff ? 1 : 20);
  }
}

ModelFile read_case(const std::string& name) {
  ModelFile model = read_model(std::string(GUDGEON_SOURCE_DIR) + "/tests/cases/" + name + ".toml");
  EXPECT_FALSE(model.diagnostics.has_errors()) << name;
  model.mechanism.name = name;
  return model;
}

TEST(Checkpoints, OfCasesGoOnWithTheSameBits) {
  for (const std::string name : {"dry_friction_formula", "force_zone", "guide_start_speed", "parallelogram_crank",
                                 "change_point_tight", "plate_pinned_twice", "press_cut", "rests_exactly_on_surface",
                                 "short_push", "start_in_the_play", "three_cranks"}) {
    const ModelFile model = read_case(name);
    expect_same_from_everywhere(model.mechanism, model.study, 1, 5, When::a_hundred_times);
    if (HasFailure()) return;
  }
}

TEST(Checkpoints, OfBristlesLightContactsAndSingularLoopsGoOnWithTheSameBits) {
  for (const std::string name : {"damped_bristles_loose", "light_worn_contacts", "singular_loop_with_clearance"}) {
    ModelFile model = read_case(name);
    model.study.cycle_driver.clear();
    model.study.cycle_time = 0.1;
    model.study.cycles = 1;
    model.study.wear_stages = 0;
    model.study.compare_ideal = false;
    model.study.outputs_per_cycle = 20;
    expect_same_from_everywhere(model.mechanism, model.study, 20, 3, When::a_hundred_times);
  }
}

// Seven thousand steps without an event: its integrator's memory cannot be saved, and starts anew in between.
TEST(Checkpoints, OfJointsThatRubGoOnWithTheSameBits) {
  Mechanism mechanism = oracle::make_slider_crank();
  const Dahl law{.kinetic_coefficient = 0.2, .bristle_stiffness = 1e4};
  std::get<Revolute>(mechanism.joints[1].kind).friction = JointFriction{law, 0.01};
  std::get<Prismatic>(mechanism.joints[3].kind).friction = JointFriction{CoulombSmooth{0.2}, 0.0, 0.2, 0.04};
  Study study = make_study(0.5, 1);
  study.integrator = Integrator::explicit_pair;
  expect_same_from_everywhere(mechanism, study);
}

TEST(Checkpoints, OfALongStiffMotionAreThereNowAndThen) {
  Study study = make_study(0.5, 4);
  study.integrator = Integrator::stiff;
  study.outputs_per_cycle = 20;
  const Mechanism mechanism = oracle::make_four_bar();
  const std::vector<StageRecord> whole = run_study(mechanism, study);
  const WatchedRun watched = run_watched(mechanism, study, 1);
  expect_same(watched.stages, whole, "checkpoints change nothing");
  ASSERT_GT(whole[0].solver.accepted_steps, 6000);
  EXPECT_GE(watched.n_offered, 6) << "one in a thousand steps";
  for (const Checkpoint& checkpoint : watched.checkpoints) {
    expect_same(resume_from(checkpoint, mechanism, study, whole), whole, std::to_string(checkpoint.time));
  }
}

// Samples that were handed over come once.
TEST(Checkpoints, OfAStreamGoOnBehindTheBlocksHandedOver) {
  Study study = make_study(0.1, 1);
  study.outputs_per_cycle = 5000;
  const Mechanism mechanism = oracle::make_slider_crank_clearance();
  const std::vector<StageRecord> whole = run_study(mechanism, study);
  std::vector<double> handed_over;
  std::optional<Checkpoint> last;
  std::vector<double> behind;
  std::atomic<bool> wanted = true;
  RunHooks hooks;
  hooks.progress = [&](const Progress&) { wanted = true; };
  hooks.samples_per_block = 300;
  const auto take = [&](const SampleBlock& block) {
    behind.insert(behind.end(), block.values[0].begin(), block.values[0].end());
  };
  hooks.samples = take;
  hooks.checkpoint_wanted = &wanted;
  hooks.checkpoint = [&](const Checkpoint& checkpoint) {
    if (checkpoint.time > 0.055) return;
    last = checkpoint;
    handed_over = behind;
  };
  (void)run_study(mechanism, study, hooks);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->n_samples_handed_over, 2700);
  EXPECT_EQ(handed_over.size(), 2700U);
  behind = handed_over;
  RunHooks later;
  later.samples_per_block = 300;
  later.samples = take;
  later.stage_finished = [&](const StageRecord& stage) {
    behind.insert(behind.end(), stage.values[0].begin(), stage.values[0].end());
  };
  (void)run_study(mechanism, study, later, {}, last);
  EXPECT_TRUE(have_same_bits(behind, whole[0].values[0]));
}

// Twenty million samples fall into a step.
TEST(Checkpoints, StopIsObeyedBetweenTheSamplesOfOneStep) {
  Study study = make_study(0.1, 1);
  study.outputs_per_cycle = 1'000'000'000;
  std::stop_source stop;
  int n_blocks = 0;
  std::optional<Checkpoint> last;
  RunHooks hooks;
  hooks.samples_per_block = 256;
  hooks.stop = stop.get_token();
  hooks.samples = [&](const SampleBlock&) {
    if (++n_blocks == 3) stop.request_stop();
  };
  hooks.checkpoint = [&](const Checkpoint& checkpoint) { last = checkpoint; };
  const auto stages = run_study(oracle::make_four_bar(), study, hooks);
  EXPECT_EQ(n_blocks, 3);
  EXPECT_EQ(stages[0].status, StageStatus::stopped);
  ASSERT_TRUE(last) << "and the rest of them is not lost";
  EXPECT_EQ(last->n_samples_handed_over, 768);
  // The rest begins with the sample behind the last one.
  std::stop_source again;
  std::vector<double> times;
  hooks.stop = again.get_token();
  hooks.samples = [&](const SampleBlock& block) {
    times.assign(block.time.begin(), block.time.end());
    again.request_stop();
  };
  (void)run_study(oracle::make_four_bar(), study, hooks, {}, last);
  ASSERT_EQ(times.size(), 256U);
  EXPECT_DOUBLE_EQ(times.front(), 768 * (0.1 / 1e9));
}

TEST(Checkpoints, OfAnotherStudyModelOrOfDamagedBytesAreRefused) {
  const Study study = make_study(0.1, 1);
  const Mechanism mechanism = oracle::make_nine_bar();
  const WatchedRun watched = run_watched(mechanism, study, 100);
  ASSERT_GT(watched.checkpoints.size(), 1U);
  Checkpoint good = watched.checkpoints[1];
  EXPECT_NO_THROW((void)run_study(mechanism, study, {}, {}, good));
  Study longer = study;
  longer.cycles = 2;
  EXPECT_THROW((void)run_study(mechanism, longer, {}, {}, good), FileError);
  EXPECT_THROW((void)run_study(oracle::make_slider_crank_clearance(), study, {}, {}, good), FileError);
  for (const std::size_t at : {std::size_t{0}, std::size_t{17}, good.state.size() / 2, good.state.size() - 1}) {
    Checkpoint flipped = good;
    flipped.state[at] = static_cast<char>(flipped.state[at] ^ 4);
    EXPECT_THROW((void)run_study(mechanism, study, {}, {}, flipped), FileError) << at;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, good.state.size() - 1}) {
    Checkpoint cut = good;
    cut.state.resize(size);
    EXPECT_THROW((void)run_study(mechanism, study, {}, {}, cut), FileError) << size;
  }
}

}  // namespace
}  // namespace gudgeon
