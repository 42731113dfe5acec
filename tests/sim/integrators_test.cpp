// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Both integrators on one motion, and bristles carried as states.
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

StageRecord run_for(const Mechanism& mechanism, double duration, Integrator integrator) {
  Study study;
  study.cycle_time = duration;
  study.cycle_driver.clear();
  study.cycles = 1;
  study.outputs_per_cycle = 50;
  study.compare_ideal = false;
  study.integrator = integrator;
  study.relative_tolerance = 1e-9;
  study.absolute_tolerance = 1e-11;
  StageRecord stage = run_study(mechanism, study).back();
  EXPECT_EQ(stage.status, StageStatus::finished) << stage.message;
  return stage;
}

double find_last(const StageRecord& stage, const std::string& channel) { return find_values(stage, channel)->back(); }

TEST(Integrators, StiffMeetsThePublishedMotion) {
  const StageRecord stage = run_for(oracle::make_slider_crank_torque(), 1.0, Integrator::stiff);
  // BDF of order 5 gathers some hundred times its tolerance in a second.
  EXPECT_NEAR(find_last(stage, "crank.angle"), 14.127892218, 1e-6);
  EXPECT_NEAR(find_last(stage, "crank.angle_rate"), 20.537482852, 1e-6);
}

TEST(Integrators, AgreeThroughImpacts) {
  const Mechanism mechanism = oracle::make_slider_crank_clearance();
  const StageRecord with_explicit = run_for(mechanism, 1e-3, Integrator::explicit_pair);
  const StageRecord with_stiff = run_for(mechanism, 1e-3, Integrator::stiff);
  EXPECT_FALSE(with_explicit.events.empty());
  EXPECT_EQ(with_stiff.events.size(), with_explicit.events.size());
  // The slider moves a millimetre in this time.
  EXPECT_NEAR(find_last(with_stiff, "slider.x"), find_last(with_explicit, "slider.x"), 1e-7);
}

Mechanism make_bristled() {
  Mechanism mechanism = oracle::make_slider_crank_clearance();
  Lugre law;
  law.static_coefficient = 0.15;
  law.kinetic_coefficient = 0.1;
  law.bristle_damping = 100.0;
  for (Joint& joint : mechanism.joints) {
    if (auto* clearance = std::get_if<RevoluteClearance>(&joint.kind)) clearance->contact.friction = law;
  }
  return mechanism;
}

// The press of the paper with bristles: a straight bristle at every onset, and closures that event location must keep.
Mechanism make_bristled_press(double bristle_damping) {
  Mechanism press = oracle::make_nine_bar();
  Lugre law;
  law.static_coefficient = 0.15;
  law.kinetic_coefficient = 0.1;
  law.bristle_damping = bristle_damping;
  for (Joint& joint : press.joints) {
    if (auto* clearance = std::get_if<RevoluteClearance>(&joint.kind)) clearance->contact.friction = law;
  }
  return press;
}

TEST(Integrators, StiffGoesThroughImpactsOfBristles) {
  const StageRecord stiff = run_for(make_bristled_press(316.0), 0.1, Integrator::stiff);
  EXPECT_GT(stiff.solver.onsets, 20);
  EXPECT_LT(std::abs(stiff.energy.residual()), 1e-8 * stiff.energy.exchanged);
}

TEST(Integrators, AllAgreeOnBristles) {
  // Before impacts have pulled neighbouring motions apart.
  const Mechanism press = make_bristled_press(10.0);
  const StageRecord with_explicit = run_for(press, 0.02, Integrator::explicit_pair);
  EXPECT_GT(with_explicit.solver.onsets, 3);
  for (const Integrator integrator : {Integrator::stiff, Integrator::automatic}) {
    const StageRecord stage = run_for(press, 0.02, integrator);
    EXPECT_EQ(stage.solver.onsets, with_explicit.solver.onsets);
    // A hundred tolerances: what impacts make of the errors before them.
    EXPECT_NEAR(find_last(stage, "slider_9.x_velocity"), find_last(with_explicit, "slider_9.x_velocity"), 1e-7);
    EXPECT_NEAR(find_last(stage, "B.normal_force"), find_last(with_explicit, "B.normal_force"), 1e-2);
  }
}

TEST(Integrators, AutomaticIsExplicitWhereNothingSticks) {
  const Mechanism mechanism = oracle::make_slider_crank_clearance();
  const StageRecord automatic = run_for(mechanism, 1e-3, Integrator::automatic);
  const StageRecord with_explicit = run_for(mechanism, 1e-3, Integrator::explicit_pair);
  EXPECT_EQ(automatic.values, with_explicit.values);
  EXPECT_EQ(automatic.solver.evaluations, with_explicit.solver.evaluations);
}

TEST(Integrators, AutomaticFollowsStickingJournalsWithFewerEvaluations) {
  const Mechanism press = oracle::make_nine_bar();
  const StageRecord automatic = run_for(press, 0.02, Integrator::automatic);
  const StageRecord with_explicit = run_for(press, 0.02, Integrator::explicit_pair);
  EXPECT_EQ(automatic.events.size(), with_explicit.events.size());
  EXPECT_NEAR(find_last(automatic, "rod_6.angle_rate"), find_last(with_explicit, "rod_6.angle_rate"), 1e-6);
  EXPECT_LT(automatic.solver.evaluations, 0.9 * static_cast<double>(with_explicit.solver.evaluations));
}

TEST(Integrators, StiffKeepsTheEnergyBalanceAsWellAsTheExplicitPair) {
  const Mechanism press = oracle::make_nine_bar();
  const auto residual = [&](Integrator integrator) {
    const EnergyBalance balance = run_for(press, 0.2, integrator).energy;
    return std::abs(balance.residual()) / balance.exchanged;
  };
  // Both are chance sums of local errors at a tolerance of 1e-9.
  EXPECT_LT(residual(Integrator::explicit_pair), 5e-9);
  EXPECT_LT(residual(Integrator::stiff), 5e-9);
}

TEST(Bristles, BendWithinTheirLimitInContactOnly) {
  const Mechanism mechanism = make_bristled();
  const StageRecord stage = run_for(mechanism, 24e-3, Integrator::explicit_pair);
  std::string joint;
  for (const Joint& one : mechanism.joints) {
    if (has_clearance(one.kind)) joint = one.name;
  }
  const auto& bristle = *find_values(stage, joint + ".bristle");
  const auto& in_contact = *find_values(stage, joint + ".in_contact");
  double largest = 0.0;
  for (std::size_t k = 0; k < bristle.size(); ++k) {
    if (in_contact[k] == 0.0) {
      EXPECT_EQ(bristle[k], 0.0) << k;
    }
    largest = std::max(largest, std::abs(bristle[k]));
  }
  EXPECT_GT(largest, 0.5e-6);                   // 0.1/1e5 m in steady slip
  EXPECT_LE(largest, 0.15 / 1e5 * (1 + 1e-6));  // static friction's deflection, and the integrator's tolerance
}

TEST(Bristles, KeepTheEnergyBalance) {
  const EnergyBalance balance = run_for(make_bristled(), 24e-3, Integrator::explicit_pair).energy;
  EXPECT_GT(balance.friction, 0.0);
  EXPECT_LT(std::abs(balance.residual()), 1e-6 * balance.exchanged);
}

}  // namespace
}  // namespace gudgeon
