// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Prescribed motion against closed forms, and the positions that end it.
#include "gudgeon/system/kinematics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/slide_motion.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Crank r, rod l, both without mass but for a trace; slider of 0.14 kg; 5000 rpm from the outer dead centre.
Mechanism make_light_rod_slider_crank() {
  Mechanism mechanism = make_ideal(oracle::make_slider_crank_clearance());
  for (const int b : {1, 2}) mechanism.bodies[b].mass = 1e-14, mechanism.bodies[b].inertia = 1e-16;
  return mechanism;
}

TEST(KinematicSolver, SliderCrankFollowsItsClosedForm) {
  const Mechanism mechanism = make_light_rod_slider_crank();
  const double r = 0.05;
  const double l = 0.12;
  const double w = mechanism.drivers[0].speed;
  KinematicSolver solver(mechanism);
  BodyMotionFinder finder(solver.system());
  const int slider = find_body(mechanism, "slider");
  for (int i = 0; i <= 400; ++i) {
    const double angle = kTurn * i / 400;
    ASSERT_TRUE(solver.move_to(angle / w));
    const BodyMotion& motion = finder.update(solver.workspace())[slider];
    // x = r cos φ + √(l² − r² sin² φ), differentiated by hand.
    const double s = std::sin(angle);
    const double c = std::cos(angle);
    const double root = std::sqrt(l * l - r * r * s * s);
    const double slope = -r * s - r * r * s * c / root;
    const double curvature = -r * c - r * r * (c * c - s * s) / root - std::pow(r * r * s * c, 2) / std::pow(root, 3);
    const double acceleration = curvature * w * w;
    EXPECT_NEAR(motion.position.x, r * c + root, 1e-10 * l);
    EXPECT_NEAR(motion.velocity.x, slope * w, 1e-10 * r * w);
    EXPECT_NEAR(motion.acceleration.x, acceleration, 1e-10 * r * w * w);
    // The light rod is in line with its force: F_x = m a, and the crank's torque gives all of the power.
    EXPECT_NEAR(solver.workspace().effort[0], 0.14 * acceleration * slope, 1e-9 * 0.14 * r * r * w * w);
    if (i == 0) {
      EXPECT_NEAR(motion.acceleration.x, -19419.36, 0.005);  // benchmarks.md, to its digits
    }
  }
}

TEST(KinematicSolver, RatesAreTheSlopesOfPositions) {
  Mechanism mechanism = oracle::make_four_bar();
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 1.1, 5.3});
  KinematicSolver solver(mechanism);
  const double h = 1e-5;
  for (const double time : {0.1, 0.43, 0.9}) {
    ASSERT_TRUE(solver.move_to(time - h));
    const MotionPoint before = solver.point();
    ASSERT_TRUE(solver.move_to(time + h));
    const MotionPoint after = solver.point();
    ASSERT_TRUE(solver.move_to(time));
    for (std::size_t k = 0; k < before.q.size(); ++k) {
      // Truncation is h² times a third derivative of some 1e3.
      EXPECT_NEAR((after.q[k] - before.q[k]) / (2.0 * h), solver.point().v[k], 1e-6);
      EXPECT_NEAR((after.v[k] - before.v[k]) / (2.0 * h), solver.point().a[k], 1e-5);
    }
  }
}

TEST(KinematicSolver, FollowingDoesNotDependOnTheStride) {
  const Mechanism mechanism = oracle::make_nine_bar();
  KinematicSolver far(mechanism);
  KinematicSolver near(mechanism);
  for (int i = 1; i <= 100; ++i) ASSERT_TRUE(near.move_to(0.01 * i));
  ASSERT_TRUE(far.move_to(1.0));
  for (std::size_t k = 0; k < near.point().q.size(); ++k) EXPECT_NEAR(far.point().q[k], near.point().q[k], 1e-11);
  KinematicSolver start(mechanism);
  for (std::size_t k = 0; k < near.point().q.size(); ++k) {
    EXPECT_NEAR(std::remainder(near.point().q[k] - start.point().q[k], kTurn), 0.0, 1e-11) << "a cycle closes";
  }
}

TEST(KinematicSolver, MissingDriversAreErrors) {
  const auto found = catch_diagnostics([] { KinematicSolver solver(oracle::make_five_bar()); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-079");
  EXPECT_THAT(found[0].message, testing::HasSubstr("2 degrees of freedom are left"));
}

/// Bars a, b, c between pivots at distance d, the first one driven from `angle` at 1 rad/s.
Mechanism make_driven_bars(double a, double b, double c, double d, double angle, double second, double third) {
  Mechanism mechanism = oracle::make_empty("bars", {}, {{"left", {0.0, 0.0}}, {"right", {d, 0.0}}});
  mechanism.bodies.push_back(oracle::make_slender("crank", a, 1.0, {}));
  mechanism.bodies.push_back(oracle::make_slender("coupler", b, 1.0, oracle::start_at(second)));
  mechanism.bodies.push_back(oracle::make_slender("rocker", c, 1.0, oracle::start_at(third)));
  oracle::add_revolute(mechanism, "left", {kFrameName, "left"}, {"crank", "a"});
  oracle::add_revolute(mechanism, "pin", {"crank", "b"}, {"coupler", "a"});
  oracle::add_revolute(mechanism, "top", {"coupler", "b"}, {"rocker", "b"});
  oracle::add_revolute(mechanism, "right", {kFrameName, "right"}, {"rocker", "a"});
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, angle, 1.0});
  return mechanism;
}

TEST(KinematicSolver, TellsWhereADriverAsksForTooMuch) {
  // Coupler and rocker in line: (b + c)² = a² + d² − 2 a d cos φ.
  const double a = 1.0;
  const double d = 1.0;
  const double limit = std::acos((a * a + d * d - 1.5 * 1.5) / (2.0 * a * d));
  KinematicSolver solver(make_driven_bars(a, 0.75, 0.75, d, 0.5, 0.0, 1.2));
  EXPECT_FALSE(solver.move_to(5.0));
  ASSERT_TRUE(solver.failure().has_value());
  EXPECT_EQ(solver.failure()->kind, MotionFailure::Kind::out_of_reach);
  EXPECT_NEAR(0.5 + solver.failure()->time, limit, 1e-9);
  EXPECT_NEAR(solver.point().time, solver.failure()->time, 1e-9) << "the last point reached is kept";
}

TEST(KinematicSolver, TellsAChangePoint) {
  // A parallelogram flattens at half a turn; two branches meet there.
  KinematicSolver solver(make_driven_bars(0.4, 1.0, 0.4, 1.0, 0.7, 0.0, 0.7));
  EXPECT_FALSE(solver.move_to(5.0));
  ASSERT_TRUE(solver.failure().has_value());
  EXPECT_EQ(solver.failure()->kind, MotionFailure::Kind::singular);
  // The motion ends where 0.4 sin φ, the least pivot against the coupler's 1, is 1e-6.
  EXPECT_NEAR(0.7 + solver.failure()->time, std::numbers::pi, 1.01e-6 / 0.4);
}

TEST(KinematicSolver, PassesNoChangePointInSteps) {
  // Steps of a degree that step over half a turn, and of half a degree that land on it.
  for (const auto& [n_steps, n_expected] : {std::pair{360, 179}, std::pair{720, 358}}) {
    const double start = std::numbers::pi / 360.0;
    KinematicSolver solver(make_driven_bars(0.1, 0.3, 0.1, 0.3, start, 0.0, start));
    int n_reached = 0;
    while (n_reached < n_steps && solver.move_to(kTurn * (n_reached + 1) / n_steps)) ++n_reached;
    ASSERT_TRUE(solver.failure().has_value()) << n_steps;
    EXPECT_EQ(n_reached, n_expected) << n_steps;
    EXPECT_EQ(solver.failure()->kind, MotionFailure::Kind::singular) << n_steps;
    EXPECT_NEAR(start + solver.failure()->time, std::numbers::pi, 1e-5) << n_steps;
    EXPECT_NEAR(solver.point().q[1], start + solver.point().time, 1e-5) << "the rocker keeps to the crank's angle";
  }
}

TEST(KinematicSolver, ReachDoesNotDependOnTheStride) {
  // The rod stands across the guide where r sin φ = l.
  Mechanism mechanism = make_light_rod_slider_crank();
  mechanism.bodies[1].points.back().position = {0.15, 0.0};
  const double limit = std::asin(0.12 / 0.15);
  for (const int n_steps : {1, 360, 36000}) {
    KinematicSolver solver(mechanism);
    const double cycle = kTurn / mechanism.drivers[0].speed;
    int n_reached = 0;
    while (n_reached < n_steps && solver.move_to(cycle * (n_reached + 1) / n_steps)) ++n_reached;
    ASSERT_TRUE(solver.failure().has_value()) << n_steps;
    EXPECT_EQ(solver.failure()->kind, MotionFailure::Kind::out_of_reach) << n_steps;
    EXPECT_NEAR(mechanism.drivers[0].speed * solver.failure()->time, limit, 1e-9) << n_steps;
  }
}

TEST(KinematicSolver, FollowsADriverThatLeavesItsRestByJerk) {
  Mechanism mechanism = make_driven_bars(0.1, 0.4, 0.3, 0.4, 0.0, 0.9, 1.6);
  mechanism.drivers[0] = {"motor", DrivenAngle{"crank"}, 0.0, 0.0, Expression{"1 + t^3", {}}};
  KinematicSolver solver(mechanism);
  for (int i = 1; i <= 20; ++i) ASSERT_TRUE(solver.move_to(0.05 * i)) << i;
  KinematicSolver uniform(make_driven_bars(0.1, 0.4, 0.3, 0.4, 1.0, 0.9, 1.6));
  ASSERT_TRUE(uniform.move_to(1.0));
  for (std::size_t k = 0; k < uniform.point().q.size(); ++k) {
    EXPECT_NEAR(solver.point().q[k], uniform.point().q[k], 1e-11) << "both have turned the crank to 2 rad";
  }
}

TEST(SlideMotion, IsSeenFromItsFirstBody) {
  // A block on a turning lever: the finite difference of its displacement gives speed and acceleration.
  Mechanism mechanism = oracle::make_six_bar_slide();
  for (Body& body : mechanism.bodies) body.start.angle_rate.reset();
  mechanism.drivers.push_back({"motor", DrivenAngle{mechanism.bodies[1].name}, *mechanism.bodies[1].start.angle, 3.0});
  KinematicSolver solver(mechanism);
  BodyMotionFinder finder(solver.system());
  const auto slide_at = [&](const Joint& joint, double time) {
    EXPECT_TRUE(solver.move_to(time));
    return find_slide_motion(solver.system().mechanism, joint, finder.update(solver.workspace()));
  };
  int n_lines = 0;
  for (const Joint& joint : solver.system().mechanism.joints) {
    if (!has_line(joint.kind)) continue;
    ++n_lines;
    const double h = 1e-5;
    const SlideMotion before = slide_at(joint, 0.3 - h);
    const SlideMotion after = slide_at(joint, 0.3 + h);
    const SlideMotion at = slide_at(joint, 0.3);
    EXPECT_NEAR((after.displacement - before.displacement) / (2.0 * h), at.speed, 1e-8);
    EXPECT_NEAR((after.speed - before.speed) / (2.0 * h), at.acceleration, 1e-7);
  }
  EXPECT_EQ(n_lines, 2);
}

}  // namespace
}  // namespace gudgeon
