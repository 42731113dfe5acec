// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Friction in ideal joints: closed forms of whole motions, what holds, and what jams.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/results/energy_balance.h"
#include "gudgeon/sim/kinematic_cycle.h"
#include "gudgeon/sim/run_study.h"
#include "gudgeon/system/assembly.h"
#include "gudgeon/system/start_check.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using oracle::make_empty;
using testing::HasSubstr;

constexpr double kFall = 9.81;
constexpr double kMu = 0.15;
// Full friction from this slip speed on, a straight line below it: a block then stops as exp(−g μ t/v_1).
constexpr double kFullSpeed = 1e-3;
const CoulombRamp kRamp{kMu, 0.0, kFullSpeed};

Study make_short_study(double end) {
  Study study;
  study.cycle_time = end;
  study.cycles = 1;
  study.outputs_per_cycle = 100;
  study.relative_tolerance = 1e-9;
  study.absolute_tolerance = 1e-11;
  return study;
}

StageRecord run_rubbing(const Mechanism& mechanism, double end) {
  const StageRecord stage = run_study(mechanism, make_short_study(end)).front();
  EXPECT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_TRUE(is_balanced(stage.energy)) << stage.energy.residual();
  return stage;
}

const std::vector<double>& read(const StageRecord& stage, const std::string& channel) {
  const std::vector<double>* found = find_values(stage, channel);
  if (found == nullptr) throw std::out_of_range(channel);
  return *found;
}

// A wheel of 2 kg and 0.01 kg m² on a horizontal pin through its centre.
Mechanism make_wheel(double radius, double rate, const AnyFriction& law) {
  Mechanism mechanism = make_empty("wheel", {0.0, -kFall}, {{"pin", {0.1, 0.2}}});
  mechanism.bodies.push_back({"wheel", 2.0, 0.01, {}, {{"hub", {}}}, oracle::start_turning(0.3, rate)});
  mechanism.joints.push_back({"pin", Revolute{{kFrameName, "pin"}, {"wheel", "hub"}, JointFriction{law, radius}}});
  return mechanism;
}

TEST(JointFriction, SlowsAWheelByTheFrictionCircle) {
  const double radius = 0.02;
  const StageRecord stage = run_rubbing(make_wheel(radius, 30.0, kRamp), 0.5);
  const double torque = radius * kMu / std::sqrt(1.0 + kMu * kMu) * 2.0 * kFall;
  EXPECT_NEAR(read(stage, "wheel.angle_rate").back(), 30.0 - torque / 0.01 * 0.5, 1e-8);
  EXPECT_NEAR(read(stage, "pin.friction_torque").back(), -torque, 1e-12);
  EXPECT_NEAR(read(stage, "pin.y_force").back(), 2.0 * kFall, 1e-11);
  EXPECT_NEAR(stage.energy.friction, torque * (30.0 * 0.5 - 0.5 * torque / 0.01 * 0.25), 1e-8);
  // μ r m g instead of the sine would be 0.22 rad/s more
  EXPECT_GT(std::abs(radius * kMu * 2.0 * kFall - torque) / 0.01 * 0.5, 0.03);
}

TEST(JointFriction, StopsAWheelEitherWay) {
  for (const double sign : {1.0, -1.0}) {
    const StageRecord stage = run_rubbing(make_wheel(0.02, sign * 2.0, kRamp), 1.0);
    EXPECT_NEAR(read(stage, "wheel.angle_rate").back(), 0.0, 1e-7);
    EXPECT_NEAR(stage.energy.friction, 0.5 * 0.01 * 4.0, 1e-9);
  }
}

// A block of 3 kg on a guide that rises at an angle.
Mechanism make_block(double angle, double speed, JointFriction friction, Vec2 center = {}) {
  Mechanism mechanism = make_empty("block", {0.0, -kFall}, {{"foot", {0.1, 0.2}}});
  mechanism.bodies.push_back({"block", 3.0, 0.01, center, {{"middle", {}}, {"side", {0.02, 0.08}}}, {}});
  Prismatic guide = oracle::make_slide({kFrameName, "foot"}, {"block", "middle"}, angle, 0.0, 0.0);
  guide.start.speed = speed;
  guide.friction = friction;
  mechanism.joints.push_back({"guide", guide});
  return mechanism;
}

TEST(JointFriction, StopsABlockAfterItsWay) {
  const double deceleration = kMu * kFall;
  for (const double length : {0.0, 0.2}) {
    const StageRecord stage = run_rubbing(make_block(0.0, 0.8, {kRamp, 0.0, length, 0.0}), 1.0);
    // below v_1 the same energy takes twice the way
    const double way = (0.64 + kFullSpeed * kFullSpeed) / (2.0 * deceleration);
    EXPECT_NEAR(read(stage, "block.x").back() - 0.1, way, 2e-8);
    EXPECT_NEAR(stage.energy.friction, 0.5 * 3.0 * 0.64, 1e-8);
  }
}

TEST(JointFriction, LetsABlockSlideDownAnIncline) {
  const double angle = 0.4;
  const StageRecord stage = run_rubbing(make_block(angle, -0.2, {kRamp, 0.0, 0.0, 0.0}), 0.6);
  const double acceleration = -kFall * (std::sin(angle) - kMu * std::cos(angle));
  const double way = -0.2 * 0.6 + 0.5 * acceleration * 0.36;
  EXPECT_NEAR(read(stage, "block.x").back() - 0.1, way * std::cos(angle), 1e-9);
  EXPECT_NEAR(read(stage, "guide.friction_force").back(), kMu * 3.0 * kFall * std::cos(angle), 1e-10);
}

// A block without weight, pushed at an offset from its guide's middle; friction has no arm to its centre of mass.
Mechanism make_pushed(double offset, double length) {
  Mechanism mechanism = make_block(0.0, 0.5, {kRamp, 0.0, length, 0.06});
  mechanism.gravity = {};
  mechanism.bodies[1].points[1].position = {0.0, offset};
  mechanism.loads.push_back({"push", ConstantForce{{"block", "side"}, {40.0, 0.0}}});
  return mechanism;
}

TEST(JointFriction, OfASlideIsThatOfItsTwoEnds) {
  // a = P (1 − 2 μ e/L)/m
  const StageRecord stage = run_rubbing(make_pushed(0.3, 0.25), 0.2);
  const double acceleration = 40.0 * (1.0 - 2.0 * kMu * 0.3 / 0.25) / 3.0;
  EXPECT_NEAR(read(stage, "block.x_velocity").back(), 0.5 + acceleration * 0.2, 1e-9);
}

TEST(JointFriction, LocksASlidePushedTooFarOutside) {
  // e > L/(2 μ): the harder the push the more it holds; what is left is the creep of the law
  const double offset = 1.25 * 0.25 / (2.0 * kMu);
  const StageRecord stage = run_rubbing(make_pushed(offset, 0.25), 1.0);
  EXPECT_NEAR(read(stage, "block.x_velocity").back(), kFullSpeed / 1.25, 1e-9);
}

// N1 and N2 from a block whose weight acts off the middle: lever 0.15 m of a guide of 0.2 m.
TEST(JointFriction, OfABlockThatTiltsIsMoreThanItsWeightMakes) {
  const Mechanism mechanism = make_block(0.0, 1.0, {kRamp, 0.0, 0.2, 0.0}, {0.15, 0.0});
  const StageRecord stage = run_rubbing(mechanism, 0.1);
  const double normal = 3.0 * kFall;
  const double ends = 2.0 / 0.2 * 0.15 * normal;  // N1 − N2 > N: one end presses on the other side
  EXPECT_NEAR(read(stage, "block.x_velocity").back(), 1.0 - kMu * ends / 3.0 * 0.1, 1e-9);
}

// A disk in a slot that gravity presses against one of its walls.
Mechanism make_rolling(double gravity, double direction) {
  Mechanism mechanism = make_empty("disk", {0.0, gravity}, {{"slot", {}}});
  BodyStart start = oracle::start_turning(0.0, 0.0);
  start.position = {0.3, 0.0};
  start.velocity = {0.9, 0.0};
  mechanism.bodies.push_back({"disk", 1.5, 0.5 * 1.5 * 0.04 * 0.04, {}, {{"centre", {}}}, start});
  mechanism.joints.push_back(
      {"slot", PinInSlot{{kFrameName, "slot"}, {"disk", "centre"}, direction, JointFriction{kRamp, 0.04}}});
  return mechanism;
}

TEST(JointFriction, BringsADiskInASlotToRollOnTheWallItTouches) {
  for (const double gravity : {-kFall, kFall}) {
    for (const double direction : {0.0, std::numbers::pi}) {
      const StageRecord stage = run_rubbing(make_rolling(gravity, direction), 1.0);
      const double speed = read(stage, "disk.x_velocity").back();
      EXPECT_NEAR(speed, 0.6, 1e-6) << gravity;  // 2/3 of what it slid with
      EXPECT_NEAR(read(stage, "disk.angle_rate").back(), (gravity < 0.0 ? -1.0 : 1.0) * speed / 0.04, 1e-4);
      EXPECT_NEAR(stage.energy.friction, 0.5 * 1.5 * 0.81 / 3.0, 1e-6);
    }
  }
}

TEST(JointFriction, OfBristlesHoldsWithoutCreep) {
  const Lugre law{
      .static_coefficient = 0.2, .kinetic_coefficient = 0.15, .bristle_stiffness = 1e5, .bristle_damping = 300.0};
  Mechanism mechanism = make_block(0.0, 0.0, {law, 0.0, 0.0, 0.0});
  const double push = 0.5 * 0.2 * 3.0 * kFall;
  mechanism.loads.push_back({"push", ConstantForce{{"block", "middle"}, {push, 0.0}}});
  const StageRecord stage = run_rubbing(mechanism, 1.0);
  EXPECT_NEAR(read(stage, "guide.bristle").back(), push / (1e5 * 3.0 * kFall), 1e-12);
  const std::vector<double>& place = read(stage, "block.x");
  EXPECT_NEAR(place.back(), place[place.size() / 2], 1e-12);
  EXPECT_NEAR(read(stage, "block.x_velocity").back(), 0.0, 1e-10);
}

// The friction of a block that is braked above its centre of mass tilts it further: for μ > L/(2 e) nothing agrees.
TEST(JointFriction, ThatJamsAtTheStartIsNamed) {
  const double offset = 1.2 * 0.1 / (2.0 * kMu);
  const Mechanism mechanism = make_block(0.0, 1.0, {kRamp, 0.0, 0.1, 0.0}, {0.0, -offset});
  try {
    run_study(mechanism, make_short_study(1.0));
    FAIL();
  } catch (const ModelError& error) {
    EXPECT_EQ(error.diagnostics().items().front().code, "E-MODEL-093");
    EXPECT_THAT(error.diagnostics().items().front().message, HasSubstr("joint 'guide' jams"));
  }
  EXPECT_NO_THROW(run_study(make_block(0.0, 1.0, {kRamp, 0.0, 0.1, 0.0}, {0.0, -0.7 * offset}), make_short_study(1.0)));
}

// A crank of 0.08 m pulls a slider in against 500 N by a rod of 0.09 m; the guide's μ is 0.6, so that the rod jams it
// where the tangent of its angle is 1/0.6.
Mechanism make_steep_slider_crank(double start, double speed) {
  Mechanism mechanism = make_empty("steep", {}, {{"pivot", {}}});
  mechanism.bodies.push_back(oracle::make_bar("crank", 0.08, 0.1, 1e-4, {}, {}));
  mechanism.bodies.push_back(oracle::make_bar("rod", 0.09, 1e-9, 1e-12, {}, oracle::start_at(0.0)));
  mechanism.bodies.push_back({"slider", 1.0, 1e-3, {}, {{"a", {}}}, {}});
  oracle::add_revolute(mechanism, "main", {kFrameName, "pivot"}, {"crank", "a"});
  oracle::add_revolute(mechanism, "big_end", {"crank", "b"}, {"rod", "a"});
  oracle::add_revolute(mechanism, "pin", {"rod", "b"}, {"slider", "a"});
  Prismatic guide = oracle::make_slide({kFrameName, "pivot"}, {"slider", "a"}, 0.0, 0.0, 0.17);
  guide.friction = JointFriction{CoulombRamp{0.6, 0.0, 1e-6}, 0.0, 0.0, 0.0};
  mechanism.joints.push_back({"guide", guide});
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, start, speed});
  mechanism.loads.push_back({"press", ConstantForce{{"slider", "a"}, {500.0, 0.0}}});
  return mechanism;
}

TEST(JointFriction, ThatJamsOnTheWayStopsTheStage) {
  // F cos β = 500 N + μ F sin β
  const Mechanism mechanism = make_steep_slider_crank(0.05, 0.2);
  const double sine = std::sin(std::atan(1.0 / 0.6)) * 0.09 / 0.08;
  ASSERT_LT(sine, 1.0);
  const StageRecord stage = run_study(mechanism, make_short_study(30.0)).front();
  EXPECT_EQ(stage.status, StageStatus::failed);
  EXPECT_THAT(stage.message, HasSubstr("E-NUM-013"));
  EXPECT_THAT(stage.message, HasSubstr("joint 'guide' jams"));
  EXPECT_NEAR(stage.end_time, (std::asin(sine) - 0.05) / 0.2, 1e-3) << stage.message;
}

TEST(JointFriction, StandsBesideALoadThatHoldsByItsJump) {
  Mechanism mechanism = make_block(0.0, 1.0, {kRamp, 0.0, 0.0, 0.0});
  VariableForce load{{"block", "middle"}};
  load.x = Expression{"3 - 5*sign(block.x_velocity)", {}};
  mechanism.loads.push_back({"brake", load});
  const StageRecord stage = run_rubbing(mechanism, 1.0);
  const double deceleration = (5.0 - 3.0) / 3.0 + kMu * kFall;
  // down to full_speed; the rest of the way is within it
  EXPECT_NEAR(read(stage, "block.x").back() - 0.1, 0.5 / deceleration, kFullSpeed * kFullSpeed / deceleration);
  EXPECT_NEAR(read(stage, "block.x_velocity").back(), 0.0, 1e-12);
}

TEST(JointFriction, RaisesTheForceThatMakesIt) {
  const KinematicRecord record = run_kinematics(make_steep_slider_crank(0.05, 0.2), {6.0, 1, 12, "motor"});
  ASSERT_EQ(record.motion.status, StageStatus::finished) << record.motion.message;
  const std::vector<double>& efforts = read(record.motion, "motor.effort");
  for (std::size_t i = 0; i < efforts.size(); ++i) {
    const double angle = 0.05 + 0.2 * record.motion.time[i];
    const double rod = std::asin(0.08 / 0.09 * std::sin(angle));
    const double force = 500.0 / (std::cos(rod) - 0.6 * std::sin(rod));
    // of the slider's 500 N its inertia is some mN
    EXPECT_NEAR(efforts[i], 0.08 * force * std::sin(angle + rod), 1e-4 * force) << angle;
  }
  const KinematicRecord jammed = run_kinematics(make_steep_slider_crank(0.05, 0.2), {10.0, 1, 20, "motor"});
  EXPECT_EQ(jammed.motion.status, StageStatus::failed);
  EXPECT_THAT(jammed.motion.message, HasSubstr("joint 'guide'"));
  EXPECT_THAT(jammed.motion.message, HasSubstr("the joint jams"));
}

TEST(JointFriction, IsRefusedWhereItsReactionIsOpen) {
  Mechanism mechanism = make_empty("table", {0.0, -kFall}, {{"one", {}}, {"two", {0.5, 0.0}}});
  mechanism.bodies.push_back({"table", 3.0, 0.1, {0.2, 0.1}, {{"a", {}}, {"b", {0.5, 0.0}}}, {}});
  Prismatic one = oracle::make_slide({kFrameName, "one"}, {"table", "a"}, 0.0, 0.0, 0.0);
  one.friction = JointFriction{kRamp, 0.0, 0.0, 0.0};
  mechanism.joints.push_back({"one", one});
  mechanism.joints.push_back({"two", oracle::make_slide({kFrameName, "two"}, {"table", "b"}, 0.0, 0.0, 0.0)});
  try {
    run_study(mechanism, make_short_study(1.0));
    FAIL();
  } catch (const ModelError& error) {
    const Diagnostic& found = error.diagnostics().items().front();
    EXPECT_EQ(found.code, "E-MODEL-092");
    EXPECT_THAT(found.message, HasSubstr("joint 'one' has friction"));
    EXPECT_THAT(found.message, HasSubstr("joints 'one', 'two' imply"));
  }
  // Without friction nothing depends on what is open: a sweep of a coefficient may begin at zero.
  std::get<Prismatic>(mechanism.joints[0].kind).friction->law = CoulombRamp{0.0, kRamp.dead_speed, kRamp.full_speed};
  EXPECT_NO_THROW(require_start(mechanism, assemble(mechanism)));
  std::get<Prismatic>(mechanism.joints[0].kind).friction.reset();
  EXPECT_NO_THROW(require_start(mechanism, assemble(mechanism)));
}

TEST(JointFriction, OfContactsIsHadByTheIdealStageThatAsksForIt) {
  const Mechanism mechanism = oracle::make_slider_crank_guide();
  Study study = make_short_study(0.25);
  study.relative_tolerance = 1e-7;
  const auto plain = run_study(mechanism, study);
  study.ideal_friction = true;
  const auto rubbing = run_study(mechanism, study);
  ASSERT_EQ(rubbing.size(), 2U);
  EXPECT_EQ(plain[0].energy.friction, 0.0);
  EXPECT_EQ(plain[1].energy.friction, rubbing[1].energy.friction) << "clearance stages are the same";
  EXPECT_TRUE(is_balanced(rubbing[0].energy));
  // the block knocks in its play, but rubs over the same way under the same load
  EXPECT_NEAR(rubbing[0].energy.friction, rubbing[1].energy.friction, 0.05 * rubbing[1].energy.friction);

  Mechanism by_hand = make_ideal(mechanism);
  const auto& block = std::get<PrismaticClearance>(mechanism.joints.back().kind);
  std::get<Prismatic>(by_hand.joints.back().kind).friction = JointFriction{
      block.contact.friction, 0.0, block.journal_length - 2.0 * block.corner_radius, block.journal_height};
  EXPECT_EQ(run_study(by_hand, study).front().energy.friction, rubbing[0].energy.friction);
}

TEST(JointFriction, IsInTheEffortsOfKinematics) {
  // a crank turned steadily on a pin under its weight: T = m g x + r sin φ |F|
  Mechanism mechanism = make_wheel(0.02, 0.0, kRamp);
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"wheel"}, 0.0, 2.0});
  const KinematicRecord record = run_kinematics(mechanism, {1.0, 1, 20, "motor"});
  const double torque = 0.02 * kMu / std::sqrt(1.0 + kMu * kMu) * 2.0 * kFall;
  for (const double effort : read(record.motion, "motor.effort")) EXPECT_NEAR(effort, torque, 1e-12);
}

}  // namespace
}  // namespace gudgeon
