// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a step promises of contacts: onsets, separations, samples, no entry unseen.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/sim/flying_ball.h"
#include "tests/sim/integrated_motion.h"

namespace gudgeon {
namespace {

// [s]: what is promised for every onset, 1e-9 of a step to either side of its aim, for steps of up to 20 ms; and what
// rounding may leave of a gap beside it.
constexpr double kOnsetTime = 4e-11;
constexpr double kRounding = 1e-14;  // [m]

// A ball across its bearing: onset, contact mode, bounce.
TEST(MotionIntegrator, OnsetLandsJustBeforeTouchAndSwitchesTheModeWithTheNextStep) {
  IntegratedMotion motion(make_balls({{{0.1, 0.0}, {3.0, 0.0}}}, {}, 1e6), {});
  while (!motion.integrator.changing_contact()) ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_EQ(motion.integrator.changing_contact(), 0U);
  EXPECT_NEAR(motion.integrator.time(), 0.4 / 3.0, kOnsetTime);
  EXPECT_LE(motion.find_contact_gap(0).penetration, 0.0);
  EXPECT_FALSE(motion.integrator.equations().contact_modes[0].in_contact) << "not yet";
  EXPECT_EQ(motion.integrator.statistics().onsets, 0);
  EXPECT_EQ(motion.integrator.find_sample(0, 0).normal_force, 0.0);

  const double speed = motion.integrator.gaps()[0].penetration_rate;
  ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_TRUE(motion.integrator.equations().contact_modes[0].in_contact);
  EXPECT_EQ(motion.integrator.equations().contact_modes[0].onset_speed, speed);
  EXPECT_NEAR(speed, 3.0, 1e-9);
  EXPECT_EQ(motion.integrator.statistics().onsets, 1);
  EXPECT_FALSE(motion.integrator.changing_contact());

  while (!motion.integrator.changing_contact()) ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_LE(motion.find_contact_gap(0).penetration, 0.0)
      << "open when it parts, so that the next onset is not this one";
  EXPECT_LT(motion.find_contact_gap(0).penetration_rate, 0.0);
  EXPECT_GT(motion.find_contact_gap(0).penetration, -3.0 * kOnsetTime);
  ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_FALSE(motion.integrator.equations().contact_modes[0].in_contact);
  EXPECT_EQ(motion.integrator.equations().contact_modes[0].onset_speed, 0.0);
  EXPECT_EQ(motion.integrator.find_sample(3, 0).normal_force, 0.0);
  EXPECT_EQ(motion.integrator.statistics().separations, 1);
}

// Whatever was tried before, and by whichever formula: a step's first samples are those of its start.
TEST(MotionIntegrator, SamplesBeginAtTheStartOfTheStep) {
  Mechanism mechanism = oracle::make_slider_crank_clearance();
  for (Joint& joint : mechanism.joints) {
    if (auto* clearance = std::get_if<RevoluteClearance>(&joint.kind)) {
      clearance->contact.friction = CoulombSmooth{0.9, 1e-4};
    }
  }
  IntegratedMotion motion(mechanism, {}, 0.012);
  const Tables& tables = motion.system.tables;
  const auto n_free = static_cast<std::size_t>(tables.counts.n_free());
  Workspace workspace(tables);
  int n_changes = 0;
  bool was_implicit = false;
  while (motion.integrator.time() < 0.012) {
    const double time = motion.integrator.time();
    const std::vector<double> y = motion.integrator.y();
    ASSERT_TRUE(motion.integrator.advance(0.012));
    if (motion.integrator.is_implicit() != was_implicit) ++n_changes;
    was_implicit = motion.integrator.is_implicit();
    eval_dynamics(tables, time, y.data(), y.data() + n_free, motion.integrator.equations().contact_modes, {},
                  workspace);
    const double force = workspace.contact_forces.front().normal_force;
    // Loops are closed after a step was sampled, by less than this.
    ASSERT_NEAR(motion.integrator.find_sample(0, 0).normal_force, force, 1e-3 * force + 1e-3) << "at " << time;
  }
  EXPECT_GT(n_changes, 10);
}

TEST(MotionIntegrator, TwoOnsetsAtOneInstant) {
  const BallFlight flight{{0.1, 0.0}, {3.0, 0.0}};
  IntegratedMotion motion(make_balls({flight, flight}, {}, 1e6), {});
  std::vector<std::size_t> order;
  std::vector<double> y(motion.integrator.y().size());
  while (order.size() < 2) {
    ASSERT_TRUE(motion.integrator.advance(1.0));
    motion.integrator.interpolate(motion.integrator.time(), y);
    EXPECT_EQ(y[3], motion.integrator.y()[3]) << "also of a step without length";
    if (!motion.integrator.changing_contact()) continue;
    order.push_back(*motion.integrator.changing_contact());
    EXPECT_NEAR(motion.integrator.time(), 0.4 / 3.0, kOnsetTime);
    EXPECT_LE(motion.find_contact_gap(order.back()).penetration, 0.0);
  }
  EXPECT_NE(order[0], order[1]);
  while (motion.integrator.time() < 0.2) ASSERT_TRUE(motion.integrator.advance(0.2));
  EXPECT_EQ(motion.integrator.statistics().onsets, 2);
}

// A level block falls on two corners. The step between their onsets is next to nothing, which says nothing about later
// ones.
TEST(MotionIntegrator, OnsetsAHairApartLeaveLaterOnesAlone) {
  for (const double tilt : {0.0, 1e-16, 1e-15, 1e-14, 1e-13}) {
    IntegratedMotion motion(oracle::make_loose_block({tilt, 0.0, Vec2{}, Vec2{0.0, -0.1}}, 200e9), {});
    while (motion.integrator.time() < 1.0) ASSERT_TRUE(motion.integrator.advance(1.0)) << tilt;
    const SolverStatistics& statistics = motion.integrator.statistics();
    EXPECT_GT(statistics.onsets, 50) << "to and fro";
    EXPECT_LT(statistics.accepted_steps, 60 * statistics.onsets) << tilt;
  }
}

// The press at every change of contact: the state that is kept, loops closed, stands where the contract says.
void expect_contract(IntegratedMotion& motion, double end, int least_onsets) {
  ASSERT_TRUE(motion.began);
  int n_onsets = 0;
  while (motion.integrator.time() < end) {
    ASSERT_TRUE(motion.integrator.advance(end));
    const auto changing = motion.integrator.changing_contact();
    for (std::size_t k = 0; k < motion.integrator.gaps().size(); ++k) {
      const bool open = !motion.integrator.equations().contact_modes[k].in_contact;
      const ContactGap gap = motion.find_contact_gap(k);
      if (open) {
        ASSERT_LE(gap.penetration, 0.0) << motion.integrator.time();
      }
      // The gaps handed out are those of the state, to the rounding of coordinates near one metre.
      ASSERT_NEAR(motion.integrator.gaps()[k].penetration, gap.penetration, 1e-15) << motion.integrator.time();
      if (changing != k || !open) continue;
      ++n_onsets;
      ASSERT_GE(gap.penetration, -kOnsetTime * gap.penetration_rate - kRounding) << motion.integrator.time();
    }
  }
  EXPECT_GE(n_onsets, least_onsets);
}

TEST(MotionIntegrator, NoEntryIsPenetratedInThePress) {
  IntegratedMotion motion(oracle::make_nine_bar(), {});
  expect_contract(motion, 0.3, 20);
}

// Loose steps whose dense output sees separations that the solution does not make, and closures that want projection
// where contacts change.
TEST(MotionIntegrator, NoEntryIsPenetratedByLooseSteps) {
  for (const double absolute : {1e-9, 1e-12}) {
    Study study;
    study.relative_tolerance = 1e-4;
    study.absolute_tolerance = absolute;
    IntegratedMotion motion(oracle::make_nine_bar(), study);
    expect_contract(motion, 0.7, 20);
    EXPECT_GT(motion.integrator.statistics().projections, 0);
  }
}

TEST(MotionIntegrator, NoEntryIsPenetratedInTheWornPress) {
  IntegratedMotion motion(oracle::make_nine_bar(), {});
  std::vector<double> depths(1000);
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = 2e-5 * (1.0 + std::sin(0.7 * static_cast<double>(k)));
  for (std::size_t k = 0; k < 2; ++k) set_surfaces(motion.system, k, depths, {});
  expect_contract(motion, 0.2, 20);
}

// Corners and pins on both sides; worn sides with a wave of four cells, 3 mm, below them.
TEST(MotionIntegrator, NoEntryIsPenetratedInSlots) {
  for (const auto& [mechanism, n_corners] :
       {std::pair{oracle::make_slider_crank_guide(), 4}, {oracle::make_scotch_yoke_clearance(), 1}}) {
    for (const bool worn : {false, true}) {
      IntegratedMotion motion(mechanism, {});
      if (worn) {
        std::vector<double> sides(800);
        for (std::size_t k = 0; k < sides.size(); ++k) sides[k] = 2e-5 * (1.0 + std::sin(1.6 * static_cast<double>(k)));
        set_surfaces(motion.system, 0, sides, std::vector<double>(static_cast<std::size_t>(400 * n_corners), 1e-6));
      }
      expect_contract(motion, 0.4, 8);
    }
  }
}

}  // namespace
}  // namespace gudgeon
