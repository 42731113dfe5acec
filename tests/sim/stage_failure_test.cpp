// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stages that cannot begin or cannot go on say why, where and when, and keep what they have.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "gudgeon/sim/stage_run.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

using testing::AllOf;
using testing::HasSubstr;

StageRecord run_within(double tolerance, const Mechanism& mechanism, double cycle_time) {
  Study study;
  study.relative_tolerance = tolerance;
  study.cycles = 1;
  study.outputs_per_cycle = 100;
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  return StageRun(system, study, cycle_time, "test").run(make_state(system, assembly), {}, {});
}

StageRecord run(const Mechanism& mechanism, double cycle_time) { return run_within(1e-6, mechanism, cycle_time); }

// A four-bar whose driven crank stretches crank and coupler against the rocker's reach and wants on.
Mechanism make_locking_four_bar() {
  Mechanism mechanism = oracle::make_four_bar();
  mechanism.loads.clear();
  mechanism.bodies[1].start = {};
  mechanism.bodies[0].points[1].position = {0.55, 0.11};
  mechanism.bodies[2].start = oracle::start_at(-0.3);
  mechanism.bodies[3].start = oracle::start_at(2.4);
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.3, 1.0});
  return mechanism;
}

TEST(StageFailure, ALoopThatCannotCloseFailsAndKeepsTheWayThere) {
  const StageRecord stage = run(make_locking_four_bar(), 3.0);
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-003: stopped at t = "), HasSubstr("(cycle 1)"),
                                   HasSubstr("the loop closed by joint '"), HasSubstr("a driver may ask")));
  EXPECT_GT(stage.end_time, 0.1);
  EXPECT_LT(stage.end_time, 3.0);
  EXPECT_EQ(stage.cycles, 0);
  ASSERT_EQ(stage.time.size(), static_cast<std::size_t>(stage.end_time / 0.03) + 1);
  for (const auto& channel : stage.values) {
    ASSERT_EQ(channel.size(), stage.time.size());
    for (const double value : channel) EXPECT_TRUE(std::isfinite(value));
  }
  EXPECT_EQ(stage.statistics.size(), stage.channels.size());
  EXPECT_TRUE(std::isfinite(stage.energy.residual()));
}

// A crank turns the end of a bar up, whose other end lies in a slot: the bar stands across the slot and is to go on.
// Nothing but the way to the singular position holds steps short then.
TEST(StageFailure, ADriverThatAsksBeyondAReachIsToldWithinFewSteps) {
  for (const double speed : {1.0, 3.0, 4.225, 11.0}) {
    Mechanism mechanism = oracle::make_empty("reach", oracle::kObliqueGravity, {{"pivot", {0, 0}}, {"slot", {0.3, 0}}});
    mechanism.bodies.push_back(oracle::make_slender("crank", 0.3, 1.0, {}));
    mechanism.bodies.push_back(oracle::make_slender("bar", 0.2, 1.0, oracle::start_at(-0.3)));
    oracle::add_revolute(mechanism, "foot", {kFrameName, "pivot"}, {"crank", "a"});
    oracle::add_revolute(mechanism, "elbow", {"crank", "b"}, {"bar", "a"});
    mechanism.joints.push_back({"end", PinInSlot{{kFrameName, "slot"}, {"bar", "b"}, 0.0}});
    mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.2, speed});
    const StageRecord stage = run_within(1e-9, mechanism, 1.0);
    EXPECT_EQ(stage.status, StageStatus::failed);
    EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-003: stopped at t = "), HasSubstr("a driver may ask")));
    EXPECT_NEAR(stage.end_time, (std::asin(2.0 / 3.0) - 0.2) / speed, 1e-6);
    EXPECT_LT(stage.solver.evaluations, 100'000);
  }
}

TEST(StageFailure, AJournalThatStartsInsideItsBearingIsTold) {
  const Mechanism mechanism = make_balls({{{0.0, 0.0}, {}}, {{kBallClearance + 12.5e-6, 0.0}, {}}}, {}, 1e6);
  const StageRecord stage = run(mechanism, 1.0);
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, AllOf(HasSubstr("joint 'wall_1'"), HasSubstr("12.5 um inside its bearing")));
  EXPECT_EQ(stage.end_time, 0.0);
  EXPECT_EQ(stage.time.size(), 1U) << "the start, to look at";
  EXPECT_TRUE(stage.events.empty());
}

TEST(StageFailure, AJournalThatJustTouchesIsNotInside) {
  EXPECT_EQ(run(make_balls({{{kBallClearance, 0.0}, {-1.0, 0.0}}}, {}, 1e6), 0.1).status, StageStatus::finished);
  const StageRecord pressed = run(make_balls({{{kBallClearance, 0.0}, {1.0, 0.0}}}, {}, 1e6), 0.1);
  EXPECT_EQ(pressed.status, StageStatus::finished) << pressed.message;
  ASSERT_EQ(pressed.events.size(), 1U) << "touches at once";
  EXPECT_NEAR(pressed.events[0].onset_time, 0.0, 1e-10);
  EXPECT_NEAR(pressed.events[0].onset_speed, 1.0, 1e-9);
}

// Straight along its slot, past the end after 0.5 m less half of the block's corners, 45 mm.
TEST(StageFailure, ABlockThatLeavesItsSlotIsTold) {
  BodyStart start;
  start.position = {0.0, 0.0};
  start.velocity = {1.0, 0.0};
  const StageRecord stage = run(oracle::make_loose_block(start, 1e9), 1.0);
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-005: stopped at t = 0.4"), HasSubstr("(cycle 1)"),
                                   HasSubstr("joint 'slot'"), HasSubstr("past the end of the slot")));
  EXPECT_GE(stage.end_time, 0.455);
  EXPECT_LE(stage.end_time, 0.455 + 0.02) << "at the end of the step it left in, which is 2 % of a cycle at most";
  EXPECT_EQ(stage.time.size(), static_cast<std::size_t>(stage.end_time / 0.01) + 1) << "the way there is kept";
}

TEST(StageFailure, ASingularStartIsTold) {
  Mechanism mechanism = oracle::make_n_four_bar(2);
  for (Body& body : mechanism.bodies) {
    if (body.name.starts_with("post")) body.start = oracle::start_at(0.0);
  }
  const StageRecord stage = run(mechanism, 1.0);
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, HasSubstr("the start position is singular"));
  EXPECT_EQ(stage.end_time, 0.0);
}

// A damper so hard that it would stop the ball within 1e-14 s, from the first touch on.
TEST(StageFailure, AContactThatPressesFromTheFirstTouchIsNamed) {
  Mechanism mechanism = make_balls({{{0.0, 0.0}, {}}, {{0.4, 0.0}, {1.0, 0.0}}}, {}, 1e6);
  std::get<RevoluteClearance>(mechanism.joints[1].kind).contact.normal_force = KelvinVoigt{1e6, 1e300};
  const StageRecord stage = run(mechanism, 1.0);
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-003"), HasSubstr("stiffest contact: joint 'wall_1'")));
  EXPECT_NEAR(stage.end_time, 0.1, 1e-10);
}

// A load beyond the last of each law that has one: the law is named, not the step.
TEST(StageFailure, ALawThatEndsIsNamed) {
  const double modulus = 0.5e9;  // [Pa] E*
  const double line = std::numbers::pi * modulus * 1.0 * kBallClearance;
  const double e = std::numbers::e;
  const std::vector<std::tuple<AnyNormalForce, std::string, double>> laws{
      {Johnson{}, "johnson", 4.0 * line / (e * e)},
      {Radzimovsky{}, "radzimovsky", line * std::exp(-1.0 / 3.0)},
      {Esdu78035{}, "esdu_78035", 4.0 * line},
      {Goldsmith{}, "goldsmith", line / (kBallBearingRadius * 0.5)},
      {DubowskyFreudenstein{}, "dubowsky_freudenstein", line / (kBallBearingRadius * 0.5)}};
  for (const auto& [law, name, force] : laws) {
    Mechanism mechanism = make_balls({{{0.0, 0.0}, {}}, {{0.49, 0.0}, {0.1, 0.0}}}, {2.0 * force, 0.0}, 1e9);
    for (Joint& joint : mechanism.joints) std::get<RevoluteClearance>(joint.kind).contact.normal_force = law;
    const StageRecord stage = run(mechanism, 1.0);
    EXPECT_EQ(stage.status, StageStatus::failed);
    EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-012: stopped at t = "), HasSubstr("(cycle 1)"),
                                     HasSubstr("joint 'wall_1': its law " + name + " has no force beyond F = "),
                                     HasSubstr(fmt::format(" = {:.0f} N", force))))
        << name;
  }
  // What it can carry, it carries.
  Mechanism light = make_balls({{{0.49, 0.0}, {0.1, 0.0}}}, {}, 1e9);
  std::get<RevoluteClearance>(light.joints[0].kind).contact.normal_force = Johnson{};
  EXPECT_EQ(run(light, 0.3).status, StageStatus::finished);
}

// A block on a guide, from 0.2 m at −1 m/s, under one load.
StageRecord run_block(const AnyLoad& load, double cycle_time) {
  Mechanism mechanism = oracle::make_empty("block", {}, {{"wall", {0.0, 0.0}}});
  mechanism.bodies.push_back({"block", 1.0, 0.1, {}, {{"eye", {0.0, 0.0}}}, {}});
  Prismatic guide = oracle::make_slide({kFrameName, "wall"}, {"block", "eye"}, 0.0, 0.0, 0.2);
  guide.start.speed = -1.0;
  mechanism.joints.push_back({"guide", guide});
  mechanism.loads.push_back({"culprit", load});
  return run(mechanism, cycle_time);
}

TEST(StageFailure, AFormulaBeyondItsRangeIsNamed) {
  const Expression root{"sqrt(block.x - 0.05)", {}};
  const StageRecord stage = run_block(VariableForce{{"block", "eye"}, 0.0, root, kFrameName}, 1.0);
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-003"), HasSubstr("load 'culprit' has no finite value here")));
  EXPECT_NEAR(stage.end_time, 0.15, 1e-9) << "kept up to where the formula ends";
}

TEST(StageFailure, AFormulaThatStartsBeyondItsRangeIsNamed) {
  const Expression root{"sqrt(block.x - 1)", {}};
  const StageRecord stage = run_block(VariableForce{{"block", "eye"}, root, 0.0, kFrameName}, 1.0);
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-001"), HasSubstr("load 'culprit' has no finite value here")));
  EXPECT_EQ(stage.end_time, 0.0);
}

TEST(StageFailure, SpringsThatPullNothingWhereTheirPointsMeetPass) {
  // k = 25 N/m without a free length is a plain oscillator, through zero and out on the other side.
  const StageRecord stage = run_block(Spring{{kFrameName, "wall"}, {"block", "eye"}, 25.0, 0.0, 0.0}, 1.0);
  EXPECT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_NEAR(find_values(stage, "block.x")->back(), 0.2 * std::cos(5.0) - 0.2 * std::sin(5.0), 1e-6);
  EXPECT_EQ(run_block(Spring{{kFrameName, "wall"}, {"block", "eye"}, 0.0, 2.0, 0.3}, 1.0).status,
            StageStatus::finished);
}

TEST(StageFailure, ContactStillOpenAtTheEndIsKept) {
  // Meets the wall after 0.1 s; the touch would last 0.02 s and more.
  const StageRecord stage = run(make_balls({{{0.2, 0.0}, {3.0, 0.0}}}, {}, 1e6), 0.105);
  ASSERT_EQ(stage.events.size(), 1U);
  EXPECT_NEAR(stage.events[0].onset_time, 0.1, 1e-10);
  EXPECT_NEAR(stage.events[0].duration, 0.005, 1e-10);
  EXPECT_GT(stage.events[0].peak_force, 0.0);
  EXPECT_GT(stage.energy.elastic, 0.0);
  EXPECT_NEAR(stage.wear.at(0).contact_time, 0.005, 1e-9);
}

}  // namespace
}  // namespace gudgeon
