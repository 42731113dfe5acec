// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Accelerating drivers, drivers between bodies and pins in slots by hand: a Scotch yoke, two discs on one axis, an arm
// on a bracket, rings of drivers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/mobility.h"
#include "gudgeon/system/reactions.h"
#include "tests/oracle/driver_motion.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Evaluated {
  explicit Evaluated(const Mechanism& mechanism, double time = 0.0)
      : assembly(assemble(mechanism, time)), system(compile(mechanism, assembly)), workspace(system.tables) {
    const State state = make_state(system, assembly);
    const std::vector<ContactMode> contact_modes(system.tables.contacts.size());
    eval_dynamics(system.tables, time, state.q.data(), state.v.data(), contact_modes, {}, workspace);
    motions = BodyMotionFinder(system).update(workspace);
    reactions = ReactionFinder(system).update(workspace, motions);
  }
  const BodyMotion& motion(const char* body) const { return motions[find_body(system.mechanism, body)]; }
  const JointReaction& reaction(const char* joint) const { return reactions[find_joint(system.mechanism, joint)]; }

  Assembly assembly;
  System system;
  Workspace workspace;
  std::vector<BodyMotion> motions;
  std::vector<JointReaction> reactions;
};

Driver make_driver(std::string name, DrivenAngle angle, const oracle::Wave& wave) {
  return {std::move(name), std::move(angle), 0.0, 0.0, oracle::make_wave(wave)};
}

// x = r cos θ(t): the yoke's slot is upright, its guide level; the crank's centre of mass is on its axis.
TEST(DrivenMotion, ScotchYokeHasItsClosedForm) {
  constexpr double kRadius = 0.09;
  constexpr double kMass = 0.8;
  constexpr double kInertia = 1.2e-3;
  Mechanism mechanism = oracle::make_empty("yoke", {}, {{"pivot", {0.0, 0.0}}});
  mechanism.bodies.push_back(oracle::make_bar("crank", kRadius, 0.5, kInertia, {}, {}));
  mechanism.bodies.push_back({"yoke", kMass, 3e-3, {}, {{"slot", {0.0, 0.0}}}, {}});
  oracle::add_revolute(mechanism, "main", {kFrameName, "pivot"}, {"crank", "a"});
  mechanism.joints.push_back({"guide", oracle::make_slide({kFrameName, "pivot"}, {"yoke", "slot"}, 0.0, 0.0, 0.05)});
  mechanism.joints.push_back({"pin", PinInSlot{{"yoke", "slot"}, {"crank", "b"}, 0.5 * std::numbers::pi}});
  mechanism.drivers.push_back(make_driver("motor", {"crank"}, {0.9, 0.0, 0.5, 7.0, 0.3}));
  for (const double t : {0.0, 0.11, 0.4, 0.75}) {
    const Evaluated at(mechanism, t);
    const auto theta = oracle::eval_motion(mechanism.drivers[0], t);
    const double sine = std::sin(theta.value);
    const double cosine = std::cos(theta.value);
    const double acceleration = -kRadius * (sine * theta.acceleration + cosine * theta.rate * theta.rate);
    EXPECT_NEAR(at.motion("yoke").position.x, kRadius * cosine, 1e-14);
    EXPECT_NEAR(at.motion("yoke").velocity.x, -kRadius * sine * theta.rate, 1e-12);
    EXPECT_NEAR(at.motion("yoke").acceleration.x, acceleration, 1e-10);
    EXPECT_NEAR(at.motion("crank").angle_acceleration, theta.acceleration, 1e-10 * 24.5);
    // From T θ̇ = I θ̈ θ̇ + m ẍ ẋ.
    const double torque = kInertia * theta.acceleration - kMass * acceleration * kRadius * sine;
    EXPECT_NEAR(at.workspace.effort[0], torque, 1e-11);
    EXPECT_NEAR(find_driver_power(at.workspace), torque * theta.rate, 1e-10);
    // The slot's side pushes the pin, the second body, across the slot only.
    EXPECT_NEAR(at.reaction("pin").force.x, -kMass * acceleration, 1e-10);
    EXPECT_NEAR(at.reaction("pin").force.y, 0.0, 1e-14);
  }
}

TEST(DrivenMotion, DriverBetweenTwoDiscsKeepsTheirMomentum) {
  Mechanism mechanism = oracle::make_empty("discs", {}, {{"axis", {0.1, 0.2}}});
  mechanism.bodies.push_back(oracle::make_bar("one", 0.1, 1.0, 0.03, {}, oracle::start_turning(0.3, 2.0)));
  mechanism.bodies.push_back(oracle::make_bar("two", 0.1, 1.0, 0.05, {}, {}));
  for (const char* body : {"one", "two"}) oracle::add_revolute(mechanism, body, {kFrameName, "axis"}, {body, "a"});
  mechanism.drivers.push_back(make_driver("motor", {"two", "one"}, {0.7, 1.5, 0.4, 6.0, 0.8}));
  const Evaluated at(mechanism);
  const auto asked = oracle::eval_motion(mechanism.drivers[0], 0.0);
  EXPECT_NEAR(at.assembly.poses[1].angle, 0.3, 1e-14) << "the driven body follows the one whose angle is given";
  EXPECT_NEAR(at.motion("two").angle - at.motion("one").angle, asked.value, 1e-13);
  EXPECT_NEAR(at.motion("two").angle_rate, 2.0 + asked.rate, 1e-10);  // the rate of an expression
  const double torque = 0.03 * 0.05 / 0.08 * asked.acceleration;
  EXPECT_NEAR(at.workspace.effort[0], torque, 1e-11);
  EXPECT_NEAR(at.motion("two").angle_acceleration, torque / 0.05, 1e-9);
  EXPECT_NEAR(at.motion("one").angle_acceleration, -torque / 0.03, 1e-9);
  EXPECT_NEAR(find_driver_power(at.workspace), torque * asked.rate, 1e-10);
}

// A bracket welded to the frame at 0.4 rad: whichever of the two is named first, the weld holds the driver's torque.
TEST(DrivenMotion, DriverAgainstABracketOnTheFrameLoadsItsWeld) {
  for (const bool arm_first : {true, false}) {
    Mechanism mechanism = oracle::make_empty("bracket", oracle::kObliqueGravity, {{"wall", {0.0, 0.0}}});
    mechanism.bodies.push_back(oracle::make_bar("bracket", 0.2, 1.0, 0.01, {}, {}));
    mechanism.bodies.push_back(oracle::make_bar("arm", 0.3, 0.8, 0.02, {0.11, 0.03}, {}));
    mechanism.joints.push_back({"weld", Rigid{{kFrameName, "wall"}, {"bracket", "a"}, 0.4}});
    oracle::add_revolute(mechanism, "hinge", {"bracket", "a"}, {"arm", "a"});
    const oracle::Wave wave{0.5, 1.1, 0.3, 7.0, 0.2};
    mechanism.drivers.push_back(
        make_driver("motor", arm_first ? DrivenAngle{"arm", "bracket"} : DrivenAngle{"bracket", "arm"}, wave));
    const Evaluated at(mechanism);
    const auto asked = oracle::eval_motion(mechanism.drivers[0], 0.0);
    const double sign = arm_first ? 1.0 : -1.0;
    EXPECT_NEAR(at.motion("arm").angle, 0.4 + sign * asked.value, 1e-13);
    const Vec2 arm = make_rotation(at.motion("arm").angle) * Vec2{0.11, 0.03};
    const double inertia = 0.02 + 0.8 * dot(arm, arm);
    const double torque = inertia * sign * asked.acceleration - 0.8 * cross(arm, oracle::kObliqueGravity);
    EXPECT_NEAR(at.workspace.effort[0], sign * torque, 1e-11);
    EXPECT_NEAR(at.reaction("weld").moment, torque, 1e-11);
    EXPECT_EQ(at.system.topology.counts.n_driven_turns, arm_first ? 1 : 0);
  }
}

// Shoulder, elbow, and the sum of both.
Mechanism make_driven_ring(double difference) {
  Mechanism mechanism = oracle::make_driven_arm(true);
  Driver whole{"whole", DrivenAngle{"hand"}};
  whole.start = oracle::eval_motion(mechanism.drivers[0], 0.0).value +
                oracle::eval_motion(mechanism.drivers[1], 0.0).value + difference;
  for (Driver& driver : mechanism.drivers) {
    driver.start = oracle::eval_motion(driver, 0.0).value;
    driver.motion = std::monostate{};
  }
  mechanism.drivers.push_back(whole);
  return mechanism;
}

TEST(DrivenMotion, DriversThatSayTheSameAreRedundantByName) {
  const Mobility mobility = find_mobility(make_driven_ring(0.0));
  EXPECT_THAT(mobility.redundant_constraints, ElementsAre("driver 'bend': its relative angle"));
  EXPECT_EQ(mobility.n_degrees_of_freedom, 1);
  const Evaluated at(make_driven_ring(0.0));
  EXPECT_EQ(at.workspace.effort[2], 0.0) << "a driver that is not needed does nothing";
}

TEST(DrivenMotion, DriversThatContradictAreNamed) {
  const auto found = catch_diagnostics([] { assemble(make_driven_ring(0.1)); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-070");
  EXPECT_EQ(found[0].path, "drivers.bend");
  EXPECT_THAT(found[0].message, HasSubstr("5.72958 deg off"));
}

// What the driver asks of the second guide is nothing but rounding.
TEST(DrivenMotion, GuideBesideADrivenOneFollows) {
  for (int k = 0; k < 30; ++k) {
    const double direction = 0.1 + 0.2 * k;
    const double turn = -1.36 + 0.17 * k;
    const Vec2 along{std::cos(direction), std::sin(direction)};
    const auto to_block = [&](Vec2 p) { return make_rotation(-turn) * (p + 0.065 * along); };
    const Vec2 near{0.09, 0.171};
    const Vec2 far{0.336, 0.179};
    Mechanism mechanism = oracle::make_empty("block", oracle::kObliqueGravity, {{"near", near}, {"far", far}});
    mechanism.bodies.push_back(
        {"block", 2.4, 0.0135, {0.05, -0.02}, {{"near", to_block(near)}, {"far", to_block(far)}}, {}});
    mechanism.joints.push_back(
        {"one", oracle::make_slide({kFrameName, "near"}, {"block", "near"}, direction, turn, 0.065)});
    mechanism.joints.push_back(
        {"two", oracle::make_slide({kFrameName, "far"}, {"block", "far"}, direction, turn, 0.065)});
    mechanism.drivers.push_back({"push", DrivenSlide{"one"}, 0.065, 0.3});
    const Evaluated at(mechanism);
    EXPECT_NEAR(norm(at.motion("block").velocity - 0.3 * along), 0.0, 1e-14) << k;
    EXPECT_NEAR(at.workspace.effort[0], -2.4 * dot(oracle::kObliqueGravity, along), 1e-12) << k;
  }
}

TEST(DrivenMotion, MobilityCountsPinsAndRelativeDrivers) {
  const std::vector<std::pair<Mechanism, int>> cases{
      {oracle::make_scotch_yoke(), 1},        {oracle::make_quick_return(), 0},   {oracle::make_trammel(), 1},
      {oracle::make_driven_arm(false), 2},    {oracle::make_driven_arm(true), 1}, {oracle::make_moved_slides(), 1},
      {oracle::make_swung_slider_crank(), 0}, {oracle::make_projectile(), 3}};
  for (const auto& [mechanism, degrees] : cases) {
    const Mobility mobility = find_mobility(mechanism);
    EXPECT_EQ(mobility.n_degrees_of_freedom, degrees) << mechanism.name;
    EXPECT_EQ(mobility.n_unknowns - mobility.n_closure_rows, degrees) << mechanism.name;
    EXPECT_EQ(mobility.n_redundant_rows, 0) << mechanism.name;
    EXPECT_FALSE(mobility.singular_start) << mechanism.name;
  }
}

TEST(DrivenMotion, AngleHeldByAWeldCannotBeDriven) {
  Mechanism mechanism = oracle::make_driven_arm(false);
  mechanism.drivers[0].target = DrivenAngle{"hand", "bracket"};
  const auto found = catch_diagnostics([&] { find_topology(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-061");
}

}  // namespace
}  // namespace gudgeon
