// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rest positions, holding efforts and frequencies against closed forms and against the least potential energy.
#include "gudgeon/system/equilibrium.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook.h"

namespace gudgeon {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFreeFall = 9.81;

/// A slender bar of 1 m and 2 kg on a pivot, with gravity along −y.
Mechanism make_pendulum(double angle) {
  Mechanism mechanism = oracle::make_empty("pendulum", {0.0, -kFreeFall}, {{"pivot", {0.0, 0.0}}});
  mechanism.bodies.push_back(oracle::make_slender("bar", 1.0, 2.0, oracle::start_turning(angle, 3.0)));
  oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"bar", "a"});
  return mechanism;
}

TEST(Equilibrium, PendulumHangs) {
  const Equilibrium found = find_equilibrium(make_pendulum(-1.2));
  EXPECT_NEAR(found.poses[1].angle, -0.5 * kPi, 1e-13);
  EXPECT_TRUE(found.is_stable());
  ASSERT_EQ(found.modes.size(), 1u);
  // ω² = m g s/(I + m s²) = 3 g/(2 L)
  EXPECT_NEAR(found.modes[0].frequency, std::sqrt(1.5 * kFreeFall) / (2.0 * kPi), 1e-10);
  EXPECT_EQ(found.modes[0].damping_ratio, 0.0);
  EXPECT_EQ(found.modes[0].most_moved, "bar");
  EXPECT_NEAR(found.reactions[0].force.y, 2.0 * kFreeFall, 1e-12);
  EXPECT_NEAR(found.reactions[0].force.x, 0.0, 1e-12);
  EXPECT_NEAR(found.potential_energy, -2.0 * kFreeFall * 0.5, 1e-12);
}

TEST(Equilibrium, PendulumStandsAndFalls) {
  const Equilibrium found = find_equilibrium(make_pendulum(1.3));
  EXPECT_NEAR(found.poses[1].angle, 0.5 * kPi, 1e-13);
  EXPECT_FALSE(found.is_stable());
  ASSERT_EQ(found.modes.size(), 1u) << "its decaying twin is not told";
  EXPECT_NEAR(found.modes[0].growth_rate, std::sqrt(1.5 * kFreeFall), 1e-9);
  EXPECT_EQ(found.modes[0].frequency, 0.0);
}

TEST(Equilibrium, DoublePendulumSwingsInTwoModes) {
  // Two point masses m on light bars L: ω² = (2 ± √2) g/L.
  Mechanism mechanism = oracle::make_empty("double", {0.0, -kFreeFall}, {{"pivot", {0.0, 0.0}}});
  for (const char* name : {"upper", "lower"}) {
    mechanism.bodies.push_back(oracle::make_bar(name, 0.5, 1.0, 0.0, {0.5, 0.0}, oracle::start_at(-1.3)));
  }
  oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"upper", "a"});
  oracle::add_revolute(mechanism, "hinge", {"upper", "b"}, {"lower", "a"});
  const Equilibrium found = find_equilibrium(mechanism);
  ASSERT_EQ(found.modes.size(), 2u);
  EXPECT_NEAR(found.modes[0].frequency, std::sqrt((2.0 - std::sqrt(2.0)) * kFreeFall / 0.5) / (2.0 * kPi), 1e-9);
  EXPECT_NEAR(found.modes[1].frequency, std::sqrt((2.0 + std::sqrt(2.0)) * kFreeFall / 0.5) / (2.0 * kPi), 1e-9);
  EXPECT_TRUE(found.is_stable());
}

TEST(Equilibrium, HeldDriverDeliversTheWeightsMoment) {
  Mechanism mechanism = make_pendulum(0.0);
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"bar"}, 0.7, 12.0});
  const Equilibrium found = find_equilibrium(mechanism);
  EXPECT_TRUE(found.modes.empty());
  EXPECT_EQ(found.poses[1].angle, 0.7);
  EXPECT_NEAR(found.efforts.at(0), 2.0 * kFreeFall * 0.5 * std::cos(0.7), 1e-12) << "no inertia force of its speed";
}

/// A mechanism of one degree of freedom with its first body at an angle and at unit rate, in the textbook form.
struct Probe {
  explicit Probe(Mechanism mechanism, const Equilibrium& near, double angle) {
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      mechanism.bodies[b].start = oracle::start_at(near.poses[b].angle);
    }
    mechanism.bodies[1].start = {};
    mechanism.drivers.push_back({"probe", DrivenAngle{mechanism.bodies[1].name}, angle, 1.0});
    const Assembly assembly = assemble(mechanism);
    const oracle::Textbook textbook(mechanism);
    oracle::TextbookState state = textbook.make_state();
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      const BodyPose& pose = assembly.poses[b];
      state.bodies[b] = textbook.place(static_cast<int>(b), pose.position, pose.angle, pose.velocity, pose.angle_rate);
    }
    energy = textbook.eval_energy(state);
    damper_power = textbook.solve(state, 0.0).loads.damper_power;
  }
  oracle::TextbookEnergy energy;
  double damper_power = 0.0;
};

/// The slope of the potential energy over the first body's angle vanishes, its curvature k, the mass m and the damping
/// d that the angle feels give λ: m λ² + d λ + k = 0.
void expect_least_energy(const Mechanism& mechanism) {
  const Equilibrium found = find_equilibrium(mechanism);
  const double angle = found.poses[1].angle;
  const auto potential = [&](double step) { return Probe(mechanism, found, angle + step).energy.potential; };
  const double h = 1e-3;  // truncation h⁴, rounding 1e-16/h² of the curvature
  const double slope = (8.0 * (potential(h) - potential(-h)) - (potential(2 * h) - potential(-2 * h))) / (12.0 * h);
  const double k =
      (16.0 * (potential(h) + potential(-h)) - (potential(2 * h) + potential(-2 * h)) - 30.0 * potential(0.0)) /
      (12.0 * h * h);
  EXPECT_NEAR(slope, 0.0, 1e-9 * std::abs(k)) << mechanism.name;
  EXPECT_NEAR(found.potential_energy, potential(0.0), 1e-10) << mechanism.name;
  const Probe at(mechanism, found, angle);
  const double m = 2.0 * at.energy.kinetic;
  const double d = at.damper_power;
  ASSERT_EQ(found.modes.size(), 1u) << mechanism.name;
  const double swing = std::sqrt(k / m - 0.25 * d * d / (m * m));
  EXPECT_NEAR(found.modes[0].frequency, swing / (2.0 * kPi), 1e-7 * swing) << mechanism.name;
  EXPECT_NEAR(found.modes[0].growth_rate, -0.5 * d / m, 1e-7 * swing) << mechanism.name;
  EXPECT_TRUE(found.is_stable()) << mechanism.name;
}

TEST(Equilibrium, FourBarsRestWhereTheirEnergyIsLeast) {
  expect_least_energy(oracle::make_sprung_four_bar());
  Mechanism hanging = oracle::make_four_bar();
  hanging.loads.clear();
  hanging.bodies[1].start = oracle::start_at(-1.3);
  hanging.bodies[2].start = oracle::start_at(0.5);
  hanging.bodies[3].start = oracle::start_at(1.2);
  expect_least_energy(hanging);
}

/// Two bars of 0.5 m with a torsion spring between them, pushed together by a force on the guide's block.
Mechanism make_strut(double force, double start) {
  Mechanism mechanism = oracle::make_empty("strut", {}, {{"pivot", {0.0, 0.0}}});
  mechanism.bodies.push_back(oracle::make_slender("lower", 0.5, 1.0, oracle::start_at(start)));
  mechanism.bodies.push_back(oracle::make_slender("upper", 0.5, 1.0, oracle::start_at(-start)));
  mechanism.bodies.push_back({"block", 0.4, 1e-3, {}, {{"a", {0.0, 0.0}}}, {}});
  oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"lower", "a"});
  oracle::add_revolute(mechanism, "knee", {"lower", "b"}, {"upper", "a"});
  oracle::add_revolute(mechanism, "pin", {"upper", "b"}, {"block", "a"});
  mechanism.joints.push_back({"guide", oracle::make_slide({kFrameName, "pivot"}, {"block", "a"}, 0.0, 0.0, 1.0)});
  mechanism.loads.push_back({"coil", TorsionSpring{"lower", "upper", 30.0, 0.0, 0.0}});
  mechanism.loads.push_back({"push", ConstantForce{{"block", "a"}, {-force, 0.0}}});
  return mechanism;
}

TEST(Equilibrium, StrutBucklesAtItsCriticalForce) {
  // V = ½ k (2θ)² − 2 F L (1 − cos θ): straight is stable below F = 2k/L = 120 N; beyond, θ/sin θ = F L/(2k).
  const Equilibrium below = find_equilibrium(make_strut(119.9, 0.0));
  EXPECT_NEAR(below.poses[1].angle, 0.0, 1e-12);
  EXPECT_TRUE(below.is_stable());
  // M = ⅓mL² (lower) + ⅓mL² (upper): both turn by θ, and the block does not move to first order.
  const double mass = 2.0 * 1.0 * 0.25 / 3.0;
  EXPECT_NEAR(below.modes.at(0).frequency, std::sqrt((4.0 * 30.0 - 2.0 * 119.9 * 0.5) / mass) / (2.0 * kPi), 1e-6);
  const Equilibrium beyond = find_equilibrium(make_strut(120.1, 0.0));
  EXPECT_NEAR(beyond.poses[1].angle, 0.0, 1e-12);
  EXPECT_FALSE(beyond.is_stable());
  const Equilibrium bent = find_equilibrium(make_strut(140.0, 0.6));
  EXPECT_TRUE(bent.is_stable());
  const double angle = bent.poses[1].angle;
  EXPECT_GT(angle, 0.5);
  EXPECT_NEAR(angle / std::sin(angle), 140.0 * 0.5 / (2.0 * 30.0), 1e-12);
}

TEST(Equilibrium, AllOfABucklingStrutAreFound) {
  // Straight, and bent to either side: the bent ones have less energy, and the same.
  const std::vector<Equilibrium> found = find_equilibria(make_strut(140.0, 0.05));
  ASSERT_GE(found.size(), 3u);
  const double angle = std::abs(found[0].poses[1].angle);
  EXPECT_NEAR(angle / std::sin(angle), 140.0 * 0.5 / (2.0 * 30.0), 1e-12);
  EXPECT_NEAR(found[1].poses[1].angle, -found[0].poses[1].angle, 1e-12);
  EXPECT_TRUE(found[0].is_stable() && found[1].is_stable());
  EXPECT_NEAR(std::remainder(found[2].poses[1].angle, kPi), 0.0, 1e-12);
  EXPECT_FALSE(found[2].is_stable());
}

TEST(Equilibrium, WholeTurnsAreNotTold) {
  // A constant torque leaves two angles, and its potential differs from turn to turn.
  Mechanism mechanism = make_pendulum(0.3);
  mechanism.loads.push_back({"motor", ConstantTorque{"bar", 4.0}});
  const std::vector<Equilibrium> found = find_equilibria(mechanism);
  ASSERT_EQ(found.size(), 2u);
  for (const Equilibrium& one : found) {
    EXPECT_NEAR(std::cos(one.poses[1].angle), 4.0 / (2.0 * kFreeFall * 0.5), 1e-12);
  }
}

TEST(Equilibrium, AllOfAPendulumAreTwoAndANeutralBarHasOne) {
  const std::vector<Equilibrium> found = find_equilibria(make_pendulum(0.3));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].is_stable());
  EXPECT_NEAR(found[1].potential_energy, 2.0 * kFreeFall * 0.5, 1e-12);
  EXPECT_FALSE(found[1].is_stable());
  Mechanism weightless = make_pendulum(0.4);
  weightless.gravity = {};
  EXPECT_EQ(find_equilibria(weightless).size(), 1u);
}

TEST(Equilibrium, BlockHangsOnItsSpring) {
  // x = m g/k below the free length; ω² = k/m with damping ratio d/(2 √(k m)).
  Mechanism mechanism = oracle::make_empty("scale", {0.0, -kFreeFall}, {{"hook", {0.0, 0.0}}});
  mechanism.bodies.push_back({"block", 3.0, 1e-3, {}, {{"eye", {0.0, 0.0}}}, {}});
  mechanism.joints.push_back(
      {"guide", oracle::make_slide({kFrameName, "hook"}, {"block", "eye"}, -0.5 * kPi, 0.0, 0.35)});
  mechanism.loads.push_back({"spring", Spring{{kFrameName, "hook"}, {"block", "eye"}, 200.0, 9.0, 0.3}});
  const Equilibrium found = find_equilibrium(mechanism);
  EXPECT_NEAR(found.poses[1].position.y, -(0.3 + 3.0 * kFreeFall / 200.0), 1e-12);
  const double ratio = 9.0 / (2.0 * std::sqrt(200.0 * 3.0));
  EXPECT_NEAR(found.modes.at(0).damping_ratio, ratio, 1e-8);
  EXPECT_NEAR(found.modes.at(0).frequency, std::sqrt(200.0 / 3.0 * (1.0 - ratio * ratio)) / (2.0 * kPi), 1e-7);
  EXPECT_EQ(found.modes.at(0).most_moved, "guide");
}

TEST(Equilibrium, AStartWhereTheLoadPeaksIsNoRest) {
  // The weight's moment is greatest there, so its slope is zero; the bar falls to where it hangs.
  const Equilibrium found = find_equilibrium(make_pendulum(kPi));
  EXPECT_NEAR(std::remainder(found.poses[1].angle + 0.5 * kPi, 2.0 * kPi), 0.0, 1e-12);
  EXPECT_TRUE(found.is_stable());
}

void expect_no_equilibrium(const Mechanism& mechanism, const char* restless) {
  try {
    find_equilibrium(mechanism);
    FAIL() << mechanism.name << ": there is none";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("E-NUM-011: no equilibrium was found: "));
    EXPECT_THAT(error.what(), testing::HasSubstr(restless));
  }
}

TEST(Equilibrium, MotionThatNothingHoldsIsTold) {
  // A torque on a crank in its dead centre, where nothing about the position changes to first order.
  expect_no_equilibrium(oracle::make_slider_crank_torque(), "'crank' at rest would still accelerate with");
  Mechanism falling = oracle::make_projectile();
  expect_no_equilibrium(falling, "'bar' at rest would still accelerate with 9.1 m/s^2");
}

TEST(Equilibrium, IsTheTextbooksAtRest) {
  // Two and three degrees of freedom, with springs, bushings and a body loose from everything else.
  for (Mechanism mechanism : {oracle::make_pod_on_bushing(), oracle::make_torsion_chain()}) {
    const Equilibrium found = find_equilibrium(mechanism);
    const oracle::Textbook textbook(found.mechanism);
    oracle::TextbookState state = textbook.make_state();
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      const BodyPose& pose = found.poses[b];
      state.bodies[b] = textbook.place(static_cast<int>(b), pose.position, pose.angle, {}, 0.0);
    }
    const oracle::TextbookSolution solution = textbook.solve(state, 0.0);
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      EXPECT_NEAR(norm(solution.accelerations[b].center), 0.0, 1e-9) << mechanism.name;
      EXPECT_NEAR(solution.accelerations[b].angle, 0.0, 1e-8) << mechanism.name;
    }
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
      EXPECT_NEAR(norm(found.reactions[j].force - solution.reactions[j].force), 0.0, 1e-9) << mechanism.name;
    }
    EXPECT_EQ(found.modes.size(), mechanism.name == "pod_on_bushing" ? 4u : 2u);
  }
}

TEST(Equilibrium, ABarThatNothingBringsBackIsNeutral) {
  Mechanism mechanism = make_pendulum(0.4);
  mechanism.gravity = {};
  const Equilibrium found = find_equilibrium(mechanism);
  ASSERT_EQ(found.modes.size(), 1u);
  EXPECT_EQ(found.modes[0].kind, EquilibriumMode::Kind::neutral);
  EXPECT_DOUBLE_EQ(found.poses[1].angle, 0.4);
}

TEST(Equilibrium, LoadsWithoutBalanceAreTold) {
  Mechanism mechanism = make_pendulum(0.4);
  mechanism.loads.push_back({"motor", ConstantTorque{"bar", 30.0}});  // more than the weight's 9.81 N m
  expect_no_equilibrium(mechanism, "'bar' at rest");
}

TEST(Equilibrium, ALoadWithoutAValueIsTold) {
  Mechanism mechanism = make_pendulum(0.4);
  mechanism.loads.push_back({"gust", VariableTorque{"bar", kFrameName, Expression{"1/0", {}}}});
  expect_no_equilibrium(mechanism, "load 'gust' has no finite value");
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"bar"}, 0.4, 1.0});
  expect_no_equilibrium(mechanism, "load 'gust' has no finite value");
}

}  // namespace
}  // namespace gudgeon
