// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dead centres and transmission angles of a crank-rocker and a slider-crank against trigonometry.
#include "gudgeon/sim/kinematic_cycle.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/system/assembly.h"
#include "tests/oracle/driver_motion.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kCrank = 0.04;
constexpr double kCoupler = 0.12;
constexpr double kRocker = 0.08;
constexpr double kFrame = 0.1;
constexpr double kStart = 0.3;  // [rad] so that nothing special falls on a sample

double find_angle_opposite(double side, double one, double other) {
  return std::acos((one * one + other * other - side * side) / (2.0 * one * other));
}

Mechanism make_crank_rocker() {
  Mechanism mechanism =
      oracle::make_empty("crank_rocker", {0.0, -9.81}, {{"left", {0.0, 0.0}}, {"right", {kFrame, 0.0}}});
  mechanism.bodies.push_back(oracle::make_slender("crank", kCrank, 0.3, {}));
  mechanism.bodies.push_back(oracle::make_slender("coupler", kCoupler, 0.9, oracle::start_at(0.6)));
  mechanism.bodies.push_back(oracle::make_slender("rocker", kRocker, 0.6, oracle::start_at(1.1)));
  oracle::add_revolute(mechanism, "left", {kFrameName, "left"}, {"crank", "a"});
  oracle::add_revolute(mechanism, "pin", {"crank", "b"}, {"coupler", "a"});
  oracle::add_revolute(mechanism, "top", {"coupler", "b"}, {"rocker", "b"});
  oracle::add_revolute(mechanism, "right", {kFrameName, "right"}, {"rocker", "a"});
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, kStart, 2.0 * kPi});
  return mechanism;
}

TEST(KinematicCycle, CrankRockerTurnsBackInLine) {
  const KinematicRecord record = run_kinematics(make_crank_rocker(), {1.0, 1, 100, "motor"});
  ASSERT_EQ(record.motion.status, StageStatus::finished);
  std::vector<DeadCentre> rocker;
  std::ranges::copy_if(record.dead_centres, std::back_inserter(rocker),
                       [](const DeadCentre& centre) { return centre.of == "rocker"; });
  ASSERT_EQ(rocker.size(), 2u);
  for (const DeadCentre& centre : rocker) {
    // Crank and coupler in line: folded (b − a) or stretched (b + a) to the rocker's end.
    const double reach = centre.is_greatest ? kCoupler - kCrank : kCoupler + kCrank;
    const double line = find_angle_opposite(kRocker, reach, kFrame);
    EXPECT_NEAR(centre.value, kPi - find_angle_opposite(reach, kRocker, kFrame), 1e-11);
    EXPECT_NEAR(centre.at.driver_value, centre.is_greatest ? line + kPi : line, 1e-10);
  }
}

TEST(KinematicCycle, TransmissionAngleObeysTheLawOfCosines) {
  const KinematicRecord record = run_kinematics(make_crank_rocker(), {1.0, 1, 100, "motor"});
  const auto& angles = *find_values(record.motion, "top.transmission_angle");
  const auto& crank = *find_values(record.motion, "motor.value");
  ASSERT_EQ(angles.size(), 101u);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double diagonal = std::sqrt(kCrank * kCrank + kFrame * kFrame - 2.0 * kCrank * kFrame * std::cos(crank[i]));
    EXPECT_NEAR(angles[i], find_angle_opposite(diagonal, kCoupler, kRocker), 1e-12);
  }
  ASSERT_EQ(record.transmissions.size(), 1u);
  const TransmissionRange& range = record.transmissions[0];
  // The extremes are where the crank is in line with the frame; values are flat there, times to the root of rounding.
  EXPECT_NEAR(range.least, find_angle_opposite(kFrame - kCrank, kCoupler, kRocker), 1e-12);
  EXPECT_NEAR(range.greatest, find_angle_opposite(kFrame + kCrank, kCoupler, kRocker), 1e-12);
  EXPECT_NEAR(std::remainder(range.least_at.driver_value, 2.0 * kPi), 0.0, 1e-6);
  EXPECT_NEAR(range.greatest_at.driver_value, kPi, 1e-6);
}

TEST(KinematicCycle, SliderTurnsBackAtBothDeadCentresEvenAtTheCyclesEnd) {
  const Mechanism mechanism = oracle::make_slider_crank_clearance();
  const double cycle = 2.0 * kPi / mechanism.drivers[0].speed;
  const KinematicRecord record = run_kinematics(mechanism, {cycle, 1, 90, "motor"});
  std::vector<DeadCentre> guide;
  std::ranges::copy_if(record.dead_centres, std::back_inserter(guide),
                       [](const DeadCentre& centre) { return centre.of == "guide"; });
  ASSERT_EQ(guide.size(), 2u);
  EXPECT_FALSE(guide[0].is_greatest);
  EXPECT_NEAR(guide[0].value, 0.12 - 0.05, 1e-13);
  EXPECT_NEAR(guide[0].at.driver_value, kPi, 1e-10);
  EXPECT_TRUE(guide[1].is_greatest);
  EXPECT_NEAR(guide[1].value, 0.12 + 0.05, 1e-13);
  EXPECT_NEAR(guide[1].at.driver_value, 2.0 * kPi, 1e-10);
  // The rod leans most where the crank stands across: sin α = r/l.
  ASSERT_EQ(record.transmissions.size(), 1u);
  EXPECT_TRUE(record.transmissions[0].is_pressure_angle);
  EXPECT_NEAR(record.transmissions[0].greatest, std::asin(0.05 / 0.12), 1e-12);
  EXPECT_TRUE(record.branch_changes.empty());
}

TEST(KinematicCycle, KeepsWhatItHasWhereTheMotionEnds) {
  Mechanism mechanism = make_crank_rocker();
  mechanism.bodies[2].points[1].position.x = 0.05;  // coupler and rocker no longer span crank and frame
  const KinematicRecord record = run_kinematics(mechanism, {1.0, 1, 100, "motor"});
  EXPECT_EQ(record.motion.status, StageStatus::failed);
  EXPECT_THAT(record.motion.message, testing::StartsWith("E-NUM-010"));
  EXPECT_THAT(record.motion.message, testing::HasSubstr("driver 'motor' at"));
  EXPECT_GT(record.motion.time.size(), 5u);
  EXPECT_LT(record.motion.time.back(), record.failure_time);
  for (const auto& values : record.motion.values) EXPECT_EQ(values.size(), record.motion.time.size());
}

TEST(KinematicCycle, DeadCentresDoNotDependOnTheSamples) {
  const KinematicRecord few = run_kinematics(make_crank_rocker(), {1.0, 1, 2, "motor"});
  const KinematicRecord many = run_kinematics(make_crank_rocker(), {1.0, 1, 500, "motor"});
  EXPECT_EQ(few.motion.time.size(), 3u);
  ASSERT_EQ(few.dead_centres.size(), many.dead_centres.size());
  for (std::size_t k = 0; k < few.dead_centres.size(); ++k) {
    EXPECT_EQ(few.dead_centres[k].of, many.dead_centres[k].of);
    EXPECT_NEAR(few.dead_centres[k].at.time, many.dead_centres[k].at.time, 1e-12);
  }
}

// The crank-rocker with a second loop over its coupler to a lever; driven at the crank or at the lever.
Mechanism make_lever_six_bar(const char* driven, double start, double speed) {
  Mechanism mechanism = make_crank_rocker();
  mechanism.bodies[0].points.push_back({"far", {0.02, 0.2}});
  mechanism.bodies[1].start = oracle::start_at(0.8);
  mechanism.bodies[2].points.push_back({"tool", {0.06, 0.04}});
  mechanism.bodies.push_back(oracle::make_slender("lever", 0.11, 0.2, oracle::start_at(-0.3)));
  mechanism.bodies.push_back(oracle::make_slender("link", 0.09, 0.2, oracle::start_at(-1.7)));
  // The coupler hangs on the rocker, so that the first loop closes at the crank's pin.
  std::swap(mechanism.joints[1], mechanism.joints[3]);
  std::swap(mechanism.joints[0], mechanism.joints[1]);
  oracle::add_revolute(mechanism, "far", {kFrameName, "far"}, {"lever", "a"});
  oracle::add_revolute(mechanism, "elbow", {"lever", "b"}, {"link", "a"});
  oracle::add_revolute(mechanism, "tool", {"link", "b"}, {"coupler", "tool"});
  mechanism.drivers[0] = {"motor", DrivenAngle{driven}, start, speed};
  mechanism.bodies[find_body(mechanism, driven)].start = {};
  return mechanism;
}

TEST(KinematicCycle, ReportsABranchThatChangesWhereNothingIsSingular) {
  // Driven at the lever, the two loops share their unknowns: no dyads. Crank and coupler come in line at the rocker's
  // dead centre, which the lever passes without a halt. Where the lever is then, the crank-driven mechanism tells.
  const double in_line = find_angle_opposite(kRocker, kCoupler + kCrank, kFrame);
  const auto find_lever = [&](double crank) {
    const Mechanism mechanism = make_lever_six_bar("crank", crank, 1.0);
    return assemble(mechanism).poses[find_body(mechanism, "lever")].angle;
  };
  const double before = find_lever(in_line - 0.2);
  const double at = find_lever(in_line);
  const double after = find_lever(in_line + 0.2);
  ASSERT_GT((at - before) * (after - at), 0.0) << "the lever turns back: another drive is needed";
  Mechanism mechanism = make_lever_six_bar("lever", before, after - before);
  const std::vector<BodyPose> start = assemble(make_lever_six_bar("crank", in_line - 0.2, 1.0)).poses;
  for (const int b : {1, 2, 3, 5}) mechanism.bodies[b].start = oracle::start_at(start[b].angle);
  const KinematicRecord record = run_kinematics(mechanism, {1.0, 1, 50, "motor"});
  ASSERT_EQ(record.motion.status, StageStatus::finished) << record.motion.message;
  ASSERT_EQ(record.branch_changes.size(), 1u);
  EXPECT_EQ(record.branch_changes[0].joint, "pin");
  EXPECT_NEAR(record.branch_changes[0].at.driver_value, at, 1e-10);
  EXPECT_TRUE(record.transmissions.empty()) << "only dyads have transmission angles";
}

TEST(KinematicCycle, TellsALoadThatGetsLost) {
  Mechanism mechanism = make_crank_rocker();
  mechanism.loads.push_back({"press", VariableTorque{"rocker", kFrameName, Expression{"sqrt(0.5 - t)", {}}}});
  const KinematicRecord record = run_kinematics(mechanism, {1.0, 1, 100, "motor"});
  EXPECT_EQ(record.motion.status, StageStatus::failed);
  EXPECT_THAT(record.motion.message, testing::HasSubstr("load 'press'"));
  EXPECT_NEAR(record.failure_time, 0.5, 1e-9);
}

TEST(KinematicCycle, FollowsADriverBetweenTwoBodies) {
  // The elbow of a driven two-link arm: the hand's angle is the sum of both drivers' values.
  Mechanism mechanism = oracle::make_driven_arm(true);
  mechanism.bodies.pop_back();  // the tassel swings freely
  mechanism.joints.pop_back();
  const KinematicRecord record = run_kinematics(mechanism, {0.4, 1, 20, {}});
  if (record.motion.status == StageStatus::failed) FAIL() << record.motion.message;
  for (const Driver& driver : mechanism.drivers) {
    const auto& target = std::get<DrivenAngle>(driver.target);
    const auto& value = *find_values(record.motion, driver.name + ".value");
    const auto& body = *find_values(record.motion, target.body + ".angle");
    for (std::size_t i = 0; i < value.size(); ++i) {
      const double against =
          target.against == kFrameName ? 0.0 : (*find_values(record.motion, target.against + ".angle"))[i];
      EXPECT_NEAR(value[i], body[i] - against, 1e-13) << driver.name;
      EXPECT_NEAR(value[i], oracle::eval_motion(driver, record.motion.time[i]).value, 1e-12) << driver.name;
    }
  }
}

}  // namespace
}  // namespace gudgeon
