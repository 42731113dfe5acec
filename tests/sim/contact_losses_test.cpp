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

Mechanism make_pushed_ball(bool with_tail) {
  Mechanism mechanism = make_balls({{}}, {}, kModulus);
  mechanism.bodies[1].start = {};
  std::get<RevoluteClearance>(mechanism.joints[0].kind).contact.normal_force = LankaraniNikravesh{kRestitution, 1.5};
  mechanism.joints.push_back(
      {"guide", Prismatic{{kFrameName, "bearing_0"}, {"ball_0", "journal"}, 0.0, 0.0, std::nullopt, std::nullopt}});
  const Expression motion{"c + a*(sin(w*t + p) - 0.4*sin(2*(w*t + p)))",
                          {{"a", kDepth}, {"c", kBallClearance}, {"p", kPhase}, {"w", kRate}}};
  mechanism.drivers.push_back({"push", DrivenSlide{"guide"}, 0.0, 0.0, motion});
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

EnergyLedger find_ledger(const Mechanism& mechanism, double tolerance) {
  Study study;
  study.cycle_time = kEnd;
  study.cycles = 1;
  study.compare_ideal = false;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-3 * tolerance;
  const auto stages = run_study(mechanism, study, {});
  EXPECT_EQ(stages.at(0).status, StageStatus::finished) << stages.at(0).message;
  return stages.at(0).ledger;
}

TEST(ContactLosses, OfSurfacesThatPartFasterThanTheyPressAreSeenByTheLedger) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-9, 1e-10}) {
    const EnergyLedger ledger = find_ledger(make_pushed_ball(true), tolerance);
    EXPECT_TRUE(check_energy(ledger).closed) << tolerance << ": " << check_energy(ledger).relative;
    EXPECT_NEAR(ledger.contact_damping, find_exact_loss(), 2e-3 * find_exact_loss());
  }
}

TEST(ContactLosses, KeepTheToleranceWhereAllIsDriven) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const EnergyLedger ledger = find_ledger(make_pushed_ball(false), tolerance);
    EXPECT_TRUE(check_energy(ledger).closed) << tolerance << ": " << check_energy(ledger).relative;
    EXPECT_NEAR(ledger.contact_damping, find_exact_loss(), (1e-8 + 10.0 * tolerance) * find_exact_loss()) << tolerance;
  }
}

}  // namespace
}  // namespace gudgeon
