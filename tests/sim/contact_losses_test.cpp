// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A ball that a driver presses slowly into a wall and pulls out nine times as fast: its force has ended long before the
// surfaces part, and what the contact had stored is lost without being felt.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

constexpr double kDepth = 5e-4;  // [m]
constexpr double kRate = 60.0;   // [rad/s]
constexpr double kPhase = -1.0;
constexpr double kRestitution = 0.7;
constexpr double kModulus = 1e9;
constexpr double kEnd = 0.1;

// How deep the ball is, and how fast it goes there.
double find_depth(double t) {
  const double angle = kRate * t + kPhase;
  return kDepth * (std::sin(angle) - 0.4 * std::sin(2.0 * angle));
}
double find_rate(double t) {
  const double angle = kRate * t + kPhase;
  return kDepth * kRate * (std::cos(angle) - 0.8 * std::cos(2.0 * angle));
}

// Pushed along its guide by the driver itself, or by a crank and a rod whose angle makes the ball go the same way.
enum class BallDrive { slide, crank };
constexpr double kCrankLength = 0.1;  // [m]
constexpr double kRodLength = 0.45;   // [m]
constexpr double kPivotPlace = -0.5;  // [m] beside the bearing's middle

Mechanism make_pushed_ball(bool with_tail, BallDrive drive = BallDrive::slide) {
  Mechanism mechanism = make_balls({{}}, {}, kModulus);
  mechanism.bodies[1].start = {};
  std::get<RevoluteClearance>(mechanism.joints[0].kind).contact.normal_force = LankaraniNikravesh{kRestitution, 1.5};
  mechanism.joints.push_back({"guide", Prismatic{{kFrameName, "bearing_0"}, {"ball_0", "journal"}, 0.0, 0.0, {}}});
  const std::string way = "(c + a*(sin(w*t + p) - 0.4*sin(2*(w*t + p))))";
  std::vector<std::pair<std::string, double>> constants{
      {"a", kDepth}, {"c", kBallClearance}, {"p", kPhase}, {"w", kRate}};
  if (drive == BallDrive::slide) {
    mechanism.drivers.push_back({"push", DrivenSlide{"guide"}, 0.0, 0.0, Expression{way, constants}});
  } else {
    // The law of cosines.
    constants.insert(constants.end(), {{"l", kRodLength}, {"o", kPivotPlace}, {"r", kCrankLength}});
    const std::string reach = "(" + way + " - o)";
    const Expression angle{"acos((" + reach + "^2 + r^2 - l^2)/(2*r*" + reach + "))", constants};
    mechanism.bodies[0].points.push_back({"pivot", {kPivotPlace, 0.0}});
    mechanism.bodies.push_back(oracle::make_bar("crank", kCrankLength, 1.0, 0.1, {}, oracle::start_at(0.9)));
    mechanism.bodies.push_back(oracle::make_bar("rod", kRodLength, 1.0, 0.1, {}, oracle::start_at(-0.2)));
    oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"crank", "a"});
    oracle::add_revolute(mechanism, "crank_pin", {"crank", "b"}, {"rod", "a"});
    oracle::add_revolute(mechanism, "wrist", {"rod", "b"}, {"ball_0", "journal"});
    mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.0, 0.0, angle});
  }
  if (!with_tail) return mechanism;
  mechanism.bodies.push_back({"tail", 0.1, 0.01, {}, {{"a", {0.3, 0.1}}}, oracle::start_at(0.3)});
  oracle::add_revolute(mechanism, "tail", {"ball_0", "journal"}, {"tail", "a"});
  return mechanism;
}

// ∫ (F − F_el) δ̇ dt from the touch on, with F = max(0, F_el (1 + χ δ̇/δ̇₀)), χ = 3 (1 − e²)/4, F_el = K δ^1.5 and
// K = 4/3 E* √R, E* = E/2, R = 1 m.
double find_exact_loss() {
  const double stiffness = 4.0 / 3.0 * 0.5 * kModulus;
  const double factor = 0.75 * (1.0 - kRestitution * kRestitution);
  const double touch = -kPhase / kRate;
  constexpr int kPoints = 400'000;
  double sum = 0.0;
  for (int k = 0; k < kPoints; ++k) {
    const double t = touch + (kEnd - touch) * (k + 0.5) / kPoints;
    const double depth = find_depth(t);
    if (depth <= 0.0) continue;
    const double elastic = stiffness * depth * std::sqrt(depth);
    const double force = std::max(0.0, elastic * (1.0 + factor * find_rate(t) / find_rate(touch)));
    sum += (force - elastic) * find_rate(t);
  }
  return sum * (kEnd - touch) / kPoints;
}

EnergyBalance find_balance(const Mechanism& mechanism, double tolerance) {
  Study study;
  study.cycle_time = kEnd;
  study.cycles = 1;
  study.compare_ideal = false;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-3 * tolerance;
  const auto stages = run_study(mechanism, study, {});
  EXPECT_EQ(stages.at(0).status, StageStatus::finished) << stages.at(0).message;
  return stages.at(0).energy;
}

TEST(ContactLosses, OfSurfacesThatPartFasterThanTheyPressAreSeenByTheEnergyBalance) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-9, 1e-10}) {
    const EnergyBalance balance = find_balance(make_pushed_ball(true), tolerance);
    EXPECT_TRUE(check_energy(balance).balanced) << tolerance << ": " << check_energy(balance).relative;
    EXPECT_NEAR(balance.contact_damping, find_exact_loss(), 2e-3 * find_exact_loss());
  }
}

TEST(ContactLosses, KeepTheToleranceWhereAllIsDriven) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const EnergyBalance balance = find_balance(make_pushed_ball(false), tolerance);
    EXPECT_TRUE(check_energy(balance).balanced) << tolerance << ": " << check_energy(balance).relative;
    EXPECT_NEAR(balance.contact_damping, find_exact_loss(), (1e-8 + 10.0 * tolerance) * find_exact_loss()) << tolerance;
  }
}

}  // namespace
}  // namespace gudgeon
