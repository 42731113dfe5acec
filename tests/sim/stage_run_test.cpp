// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a stage keeps: samples, statistics, contacts and wear of the counted cycles, also of one that ends early.
#include "gudgeon/sim/stage_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;

struct Limits {
  std::stop_token stop;
  std::function<void(double)> progress;
};

StageRecord run(const Mechanism& mechanism, const Study& study, double cycle_time, const Limits& limits = {}) {
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  return StageRun(system, study, cycle_time, "test").run(make_state(system, assembly), limits.stop, limits.progress);
}

Study make_study(int warm_up_cycles, int cycles, int outputs_per_cycle = 40) {
  Study study;
  study.warm_up_cycles = warm_up_cycles;
  study.cycles = cycles;
  study.outputs_per_cycle = outputs_per_cycle;
  study.relative_tolerance = 1e-10;
  study.absolute_tolerance = 1e-12;
  return study;
}

// To and fro in its bearing, rubbing and wearing.
Mechanism make_bouncing_ball() {
  Mechanism mechanism = make_balls({{{0.1, 0.05}, {3.0, 0.4}, 6.0}}, {}, 1e7);
  auto& joint = std::get<RevoluteClearance>(mechanism.joints[0].kind);
  joint.contact.friction = CoulombSmooth{0.1, 0.05};
  joint.contact.bearing_wear = joint.contact.journal_wear = Archard{1e-9};
  return mechanism;
}

TEST(StageRun, SamplesStandAtEvenTimesFromStartToEnd) {
  // A cycle of an awkward length: the last sample must not fall to rounding.
  for (const auto& [warm_up, cycles, outputs] : {std::tuple{0, 1, 1}, {0, 3, 7}, {2, 3, 10}, {1, 7, 13}}) {
    const double cycle_time = 0.1 / 3.0;
    const StageRecord stage = run(oracle::make_four_bar(), make_study(warm_up, cycles, outputs), cycle_time);
    EXPECT_EQ(stage.name, "test");
    ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
    ASSERT_EQ(stage.time.size(), static_cast<std::size_t>(cycles) * outputs + 1);
    for (std::size_t k = 0; k < stage.time.size(); ++k) {
      EXPECT_DOUBLE_EQ(stage.time[k], cycle_time * warm_up + cycle_time / outputs * static_cast<double>(k));
    }
    for (const auto& channel : stage.values) EXPECT_EQ(channel.size(), stage.time.size());
    EXPECT_DOUBLE_EQ(stage.start_time, cycle_time * warm_up);
    EXPECT_DOUBLE_EQ(stage.end_time, cycle_time * (warm_up + cycles));
    EXPECT_EQ(stage.cycles, cycles);
    EXPECT_EQ(stage.cycle_time, cycle_time);
  }
}

TEST(StageRun, FirstAndLastSampleAreTheEndsOfTheMotion) {
  const StageRecord stage = run(oracle::make_four_bar(), make_study(0, 2), 0.15);
  const Assembly assembly = assemble(oracle::make_four_bar());
  EXPECT_EQ(stage.time[0], 0.0);
  EXPECT_DOUBLE_EQ(find_values(stage, "crank.angle")->front(), assembly.poses[1].angle);
  EXPECT_DOUBLE_EQ(find_values(stage, "crank.angle_rate")->front(), assembly.poses[1].angle_rate);
  EXPECT_EQ(find_values(stage, "energy.residual")->front(), 0.0);
  // The energy balance is closed at the end: with the accuracy of the run, as projection comes after dense output.
  const double kinetic = stage.energy.kinetic;
  EXPECT_NEAR(find_values(stage, "energy.kinetic")->back(), kinetic, 1e-8 * kinetic);
  EXPECT_NEAR(find_values(stage, "energy.potential")->back(), stage.energy.potential, 1e-8 * kinetic);
}

TEST(StageRun, SamplesAreTheMotionWhateverItsSteps) {
  // Straight flight at 1.5 m/s until the wall is met after 0.2 s.
  const StageRecord stage = run(make_balls({{{0.2, 0.0}, {1.5, 0.0}}}, {}, 1e6), make_study(0, 1, 17), 0.19);
  for (std::size_t k = 0; k < stage.time.size(); ++k) {
    EXPECT_NEAR(find_values(stage, "ball_0.x")->at(k), 0.2 + 1.5 * stage.time[k], 1e-14);  // rounding of a sum
  }
  EXPECT_TRUE(stage.events.empty());
}

// Two cycles, of which the first counts or not: what counts must add up.
TEST(StageRun, WarmUpIsLeftOutOfWearAndContacts) {
  const double cycle_time = 0.71;
  const StageRecord first = run(make_bouncing_ball(), make_study(0, 1), cycle_time);
  const StageRecord both = run(make_bouncing_ball(), make_study(0, 2), cycle_time);
  const StageRecord second = run(make_bouncing_ball(), make_study(1, 1), cycle_time);
  ASSERT_GE(first.events.size(), 2U);
  ASSERT_EQ(both.events.size(), first.events.size() + second.events.size());
  for (std::size_t k = 0; k < second.events.size(); ++k) {
    const ContactEvent& event = second.events[k];
    EXPECT_GE(event.onset_time, cycle_time);
    // Runs whose steps differ agree as far as their tolerance of 1e-10 grows over a few bounces.
    EXPECT_NEAR(event.onset_time, both.events[first.events.size() + k].onset_time, 1e-6);
  }
  const JointWear& a = first.wear.at(0);
  const JointWear& b = second.wear.at(0);
  const JointWear& sum = both.wear.at(0);
  EXPECT_NEAR(a.impulse + b.impulse, sum.impulse, 1e-6 * sum.impulse);
  EXPECT_NEAR(a.sliding_distance + b.sliding_distance, sum.sliding_distance, 1e-6 * sum.sliding_distance);
  EXPECT_NEAR(a.contact_time + b.contact_time, sum.contact_time, 1e-6 * sum.contact_time);
  EXPECT_NEAR(a.archard_volume + b.archard_volume, sum.archard_volume, 1e-6 * sum.archard_volume);
  // Twice the momentum along the normal, a bounce: no impulse is missed between.
  EXPECT_GT(a.impulse, 2.0 * 2.0 * 2.0 * static_cast<double>(first.events.size()));
  // The energy balance is that of the whole.
  EXPECT_NEAR(second.energy.friction, both.energy.friction, 1e-6 * both.energy.friction);
  EXPECT_LT(first.energy.friction, both.energy.friction);
}

TEST(StageRun, WarmUpIsLeftOutOfStatistics) {
  // Slides down an oblique guide and swings: positions pass 0.3 s at other values than they start with.
  const double cycle_time = 0.3;
  const StageRecord all = run(oracle::make_two_slides(), make_study(0, 2, 100), cycle_time);
  const StageRecord late = run(oracle::make_two_slides(), make_study(1, 1, 100), cycle_time);
  for (std::size_t k = 0; k < all.channels.size(); ++k) {
    const ChannelStatistics& of = late.statistics[k];
    EXPECT_GE(of.minimum_time, cycle_time) << of.channel;
    EXPECT_GE(of.maximum_time, cycle_time) << of.channel;
    const auto [least, most] = std::ranges::minmax(late.values[k]);
    // Peaks at steps and samples of a smooth motion differ by the curvature between them.
    const double range = 1e-3 * (most - least) + 1e-9;
    EXPECT_LE(of.minimum, least + range) << of.channel;
    EXPECT_GE(of.maximum, most - range) << of.channel;
  }
}

// Counted time begins with its first instant: the extremes of sampled channels are those of the samples, and a peak at
// the start is one of the steps' too.
TEST(StageRun, StatisticsBeginWithTheFirstCountedInstant) {
  for (const int warm_up : {0, 1}) {
    const StageRecord stage = run(oracle::make_pendulum_chain(1), make_study(warm_up, 1, 5), 0.05);
    for (const char* channel : {"bar_1.angle", "bar_1.x", "bar_1.y_velocity", "energy.kinetic"}) {
      const auto [least, most] = std::ranges::minmax(*find_values(stage, channel));
      EXPECT_EQ(find_statistics(stage, channel)->minimum, least) << channel << warm_up;
      EXPECT_EQ(find_statistics(stage, channel)->maximum, most) << channel << warm_up;
    }
    const std::vector<double>& acceleration = *find_values(stage, "bar_1.angle_acceleration");
    const ChannelStatistics& of = *find_statistics(stage, "bar_1.angle_acceleration");
    const bool rises = acceleration.front() < acceleration.back();
    EXPECT_EQ(rises ? of.minimum_time : of.maximum_time, stage.start_time) << warm_up;
  }
}

TEST(StageRun, StopsBeforeTheFirstStepWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const StageRecord stage = run(oracle::make_four_bar(), make_study(0, 2), 0.5, {source.get_token(), {}});
  EXPECT_EQ(stage.status, StageStatus::stopped);
  EXPECT_THAT(stage.message, HasSubstr("stopped on request at t = 0 s"));
  EXPECT_EQ(stage.end_time, 0.0);
  EXPECT_EQ(stage.cycles, 0);
  EXPECT_EQ(stage.time, std::vector<double>{0.0});
}

TEST(StageRun, StoppedOnTheWayKeepsWhatItHas) {
  std::stop_source source;
  Limits limits{source.get_token(), [&](double done) {
                  if (done > 0.6) source.request_stop();
                }};
  const StageRecord stage = run(make_bouncing_ball(), make_study(0, 2), 0.71, limits);
  const StageRecord whole = run(make_bouncing_ball(), make_study(0, 2), 0.71);
  EXPECT_EQ(stage.status, StageStatus::stopped);
  EXPECT_EQ(stage.cycles, 1);
  ASSERT_LT(stage.time.size(), whole.time.size());
  EXPECT_GE(stage.time.size(), 0.6 * static_cast<double>(whole.time.size()) - 1.0);
  for (std::size_t k = 0; k < stage.values.size(); ++k) {
    ASSERT_EQ(stage.values[k].size(), stage.time.size());
    EXPECT_TRUE(std::equal(stage.values[k].begin(), stage.values[k].end(), whole.values[k].begin(),
                           [](double a, double b) { return a == b; }))
        << "same bits as far as they go: " << stage.channels[k].name;
  }
  EXPECT_GT(stage.wear.at(0).impulse, 0.0);
  EXPECT_LT(std::abs(stage.energy.residual()), 1e-6 * stage.energy.initial_energy);
}

TEST(StageRun, ProgressGrowsToOne) {
  std::vector<double> reported;
  run(oracle::make_four_bar(), make_study(1, 2), 0.2, {{}, [&](double done) { reported.push_back(done); }});
  ASSERT_FALSE(reported.empty());
  EXPECT_TRUE(std::ranges::is_sorted(reported));
  EXPECT_LE(reported.size(), 100U);
  EXPECT_EQ(reported.back(), 1.0);
}

}  // namespace
}  // namespace gudgeon
