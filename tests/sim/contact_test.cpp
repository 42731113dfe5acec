// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A ball in flight against closed forms: delivered restitution, contact time, peak force and deepest penetration of a
// free mass that meets a wall, through the whole of the engine: event location, contact mode, force, step control.
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

constexpr double kBearingRadius = 1.0;
constexpr double kClearance = 0.5;

// A mass whose journal flies along x towards the bearing of the frame; the stiffness is K [N/m^1.5].
Mechanism make_flight(double mass, double speed, double stiffness, AnyNormalForce law) {
  Mechanism mechanism;
  mechanism.name = "flight";
  mechanism.bodies.push_back({kFrameName, 0.0, 0.0, {}, {{"bearing", {0.0, 0.0}}}, {}});
  BodyStart start;
  start.angle = 0.0;
  start.velocity = Vec2{speed, 0.0};
  start.angle_rate = 0.0;
  mechanism.bodies.push_back({"ball", mass, 1.0, {}, {{"journal", {0.0, 0.0}}}, start});
  // 4/(3 π (σ_i + σ_j)) sqrt(R_i R_j/c) = K for two equal surfaces without lateral contraction.
  const double root = std::sqrt(kBearingRadius * (kBearingRadius - kClearance) / kClearance);
  const Material material{"test", 1.5 * stiffness / root, 0.0};
  RevoluteClearance joint{{kFrameName, "bearing"}, {"ball", "journal"}, kBearingRadius, kClearance, 1.0, {}};
  joint.contact.bearing_material = joint.contact.journal_material = material;
  joint.contact.normal_force = law;
  joint.contact.friction = Frictionless{};
  mechanism.joints.push_back({"wall", joint});
  return mechanism;
}

StageRecord run_flight(const Mechanism& mechanism, double duration, double max_step = 0.0) {
  Study study;
  study.max_step = max_step;
  study.cycle_time = duration;
  study.cycles = 1;
  study.outputs_per_cycle = 100;
  study.compare_ideal = false;
  study.relative_tolerance = 1e-12;
  study.absolute_tolerance = 1e-14;
  auto stages = run_study(mechanism, study);
  EXPECT_EQ(stages.at(0).status, StageStatus::finished) << stages[0].message;
  return stages.at(0);
}

TEST(Contact, HertzTimeForceAndDepth) {
  // K = 1e6 N/m^1.5, m = 2 kg, δ̇₀ = 3 m/s: closed form of laws.md. The wall is reached after 1/6 s.
  // Peaks are taken at steps: short ones, so that the one nearest to the peak misses it by 1e-7 at most.
  const StageRecord stage = run_flight(make_flight(2.0, 3.0, 1e6, Hertz{}), 0.2, 1e-6);
  ASSERT_EQ(stage.events.size(), 1U);
  const ContactEvent& contact = stage.events[0];
  EXPECT_NEAR(contact.onset_time, kClearance / 3.0, 1e-10);  // the promise for every onset
  EXPECT_NEAR(contact.onset_speed, 3.0, 3e-9);
  EXPECT_NEAR(contact.angle, 0.0, 1e-12);
  EXPECT_NEAR(contact.duration / 0.0135700858, 1.0, 1e-6);
  EXPECT_NEAR(find_statistics(stage, "wall.normal_force")->maximum / 1626.70766, 1.0, 1e-6);
  EXPECT_NEAR(find_statistics(stage, "wall.penetration")->maximum / 0.0138316187, 1.0, 1e-6);
  EXPECT_NEAR(find_values(stage, "ball.x_velocity")->back(), -3.0, 1e-8);
}

struct Restitution {
  double asked;
  double delivered;  // root of the closed form χ (1 + e_out) = ln[(1 + χ)/(1 − χ e_out)]
};

class DeliveredRestitution : public testing::TestWithParam<Restitution> {};

TEST_P(DeliveredRestitution, LankaraniNikravesh) {
  const auto [asked, delivered] = GetParam();
  const StageRecord stage = run_flight(make_flight(2.0, 3.0, 1e6, LankaraniNikravesh{asked, 1.5}), 0.25);
  // Printed with five decimals; the issue asks for 1e-4.
  EXPECT_NEAR(find_values(stage, "ball.x_velocity")->back() / -3.0, delivered, 1e-5);
  // What the ball lost is what the energy balance says was damped.
  EXPECT_NEAR(stage.energy.contact_damping, 9.0 * (1.0 - delivered * delivered), 2e-4);
  EXPECT_LT(std::abs(stage.energy.residual()), 1e-8 * stage.energy.initial_energy);
}

INSTANTIATE_TEST_SUITE_P(Laws, DeliveredRestitution,
                         testing::Values(Restitution{0.1, .66527}, Restitution{0.3, .68422}, Restitution{0.5, .72524},
                                         Restitution{0.7, .79597}, Restitution{0.9, .91318},
                                         Restitution{0.99, .99015}));

TEST(Contact, BounceIndependentOfMassSpeedAndStiffness) {
  for (const double speed : {0.05, 20.0}) {
    const StageRecord stage = run_flight(make_flight(0.3, speed, 5e8, LankaraniNikravesh{}), 1.2 * kClearance / speed);
    EXPECT_NEAR(find_values(stage, "ball.x_velocity")->back() / -speed, 0.91318, 1e-5) << speed;
  }
}

TEST(Contact, NoEntryIsMissedInLongFlight) {
  // Without forces in flight the error control would let steps grow past any contact.
  Mechanism mechanism = make_flight(2.0, 3.0, 1e6, Hertz{});
  Study study;
  study.cycle_time = 40.0;
  study.cycles = 1;
  study.outputs_per_cycle = 1000;
  study.compare_ideal = false;
  const StageRecord stage = run_study(mechanism, study).at(0);
  // To and fro across a free width of 2c at 3 m/s, each bounce lasting the Hertz contact time.
  const double period = 2.0 * kClearance / 3.0 + 0.0135700858;
  EXPECT_EQ(stage.events.size(), static_cast<std::size_t>((40.0 - kClearance / 3.0) / period) + 1);
  for (const double depth : *find_values(stage, "wall.penetration")) EXPECT_LT(depth, 0.0139);
}

}  // namespace
}  // namespace gudgeon
