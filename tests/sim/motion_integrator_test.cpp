// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The contract of a step: milestones, contact changes, closures, dense output.
#include "gudgeon/sim/motion_integrator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

constexpr double kOnsetTime = 1e-10;  // [s]: what is promised for every onset

struct Motion {
  Motion(const Mechanism& mechanism, Study settings, double cycle_time = 1.0)
      : study(std::move(settings)),
        assembly(assemble(mechanism)),
        system(compile(mechanism, assembly)),
        integrator(system, study, cycle_time),
        began(integrator.begin(make_state(system, assembly))) {}

  // The gap of one contact at the integrator's own state, all anew.
  ContactGap find_contact_gap(std::size_t contact) const {
    Workspace workspace(system.tables);
    const double* y = integrator.y().data();
    const auto n_free = static_cast<std::size_t>(system.tables.counts.n_free());
    update_coordinates(system.tables, integrator.time(), y, y + n_free, workspace.coordinates);
    update_point_motions(system.tables, workspace);
    const Contact& at = system.tables.contacts[contact];
    return find_gap(at.surfaces, find_contact_motion(at, workspace));
  }

  Study study;
  Assembly assembly;
  System system;
  MotionIntegrator integrator;
  bool began;
};

TEST(MotionIntegrator, HitsMilestonesExactly) {
  Motion motion(oracle::make_four_bar(), {});
  ASSERT_TRUE(motion.began);
  for (const double milestone : {0.1, 0.1 + 1e-9, 1.0 / 3.0, 0.7, 1.0}) {
    int n_steps = 0;
    while (motion.integrator.time() < milestone) {
      ASSERT_TRUE(motion.integrator.advance(milestone));
      ASSERT_LE(motion.integrator.time(), milestone);
      ASSERT_LT(++n_steps, 10000);
    }
    EXPECT_EQ(motion.integrator.time(), milestone);
  }
}

TEST(MotionIntegrator, StepsAreNoLongerThanAllowed) {
  Study study;
  Motion free(make_balls({{{}, {}}}, {}, kNoStiffness), study);  // nothing moves: no error would stop its steps
  while (free.integrator.time() < 1.0) ASSERT_TRUE(free.integrator.advance(1.0));
  EXPECT_NEAR(free.integrator.statistics().largest_step, 0.02, 1e-15) << "a fiftieth of the cycle";
  study.max_step = 0.003;
  Motion held(make_balls({{{}, {}}}, {}, kNoStiffness), study);
  while (held.integrator.time() < 1.0) ASSERT_TRUE(held.integrator.advance(1.0));
  EXPECT_NEAR(held.integrator.statistics().largest_step, 0.003, 1e-15);
}

// A ball across its bearing: onset, latch, bounce.
TEST(MotionIntegrator, OnsetLandsJustBeforeTouchAndTurnsTheLatchWithTheNextStep) {
  Motion motion(make_balls({{{0.1, 0.0}, {3.0, 0.0}}}, {}, 1e6), {});
  while (!motion.integrator.changing_contact()) ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_EQ(motion.integrator.changing_contact(), 0U);
  EXPECT_NEAR(motion.integrator.time(), 0.4 / 3.0, kOnsetTime);
  EXPECT_LE(motion.find_contact_gap(0).penetration, 0.0);
  EXPECT_FALSE(motion.integrator.equations().latches[0].in_contact) << "not yet";
  EXPECT_EQ(motion.integrator.statistics().onsets, 0);
  EXPECT_EQ(motion.integrator.find_sample(0, 0).normal_force, 0.0);

  const double speed = motion.integrator.gaps()[0].penetration_rate;
  ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_TRUE(motion.integrator.equations().latches[0].in_contact);
  EXPECT_EQ(motion.integrator.equations().latches[0].onset_speed, speed);
  EXPECT_NEAR(speed, 3.0, 1e-9);
  EXPECT_EQ(motion.integrator.statistics().onsets, 1);
  EXPECT_FALSE(motion.integrator.changing_contact());

  while (!motion.integrator.changing_contact()) ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_LE(motion.find_contact_gap(0).penetration, 0.0)
      << "open when it parts, so that the next onset is not this one";
  EXPECT_LT(motion.find_contact_gap(0).penetration_rate, 0.0);
  EXPECT_GT(motion.find_contact_gap(0).penetration, -3.0 * kOnsetTime);
  ASSERT_TRUE(motion.integrator.advance(1.0));
  EXPECT_FALSE(motion.integrator.equations().latches[0].in_contact);
  EXPECT_EQ(motion.integrator.equations().latches[0].onset_speed, 0.0);
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
  Motion motion(mechanism, {}, 0.012);
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
    eval_dynamics(tables, time, y.data(), y.data() + n_free, motion.integrator.equations().latches, {}, workspace);
    const double force = workspace.contact_forces.front().normal_force;
    // Loops are closed after a step was sampled, by less than this.
    ASSERT_NEAR(motion.integrator.find_sample(0, 0).normal_force, force, 1e-3 * force + 1e-3) << "at " << time;
  }
  EXPECT_GT(n_changes, 10);
}

TEST(MotionIntegrator, TwoOnsetsAtOneInstant) {
  const BallFlight flight{{0.1, 0.0}, {3.0, 0.0}};
  Motion motion(make_balls({flight, flight}, {}, 1e6), {});
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
    Motion motion(oracle::make_loose_block({tilt, 0.0, Vec2{}, Vec2{0.0, -0.1}}, 200e9), {});
    while (motion.integrator.time() < 1.0) ASSERT_TRUE(motion.integrator.advance(1.0)) << tilt;
    const SolverStatistics& statistics = motion.integrator.statistics();
    EXPECT_GT(statistics.onsets, 50) << "to and fro";
    EXPECT_LT(statistics.accepted_steps, 60 * statistics.onsets) << tilt;
  }
}

// The press at every change of contact: the state that is kept, loops closed, stands where the contract says.
void expect_contract(Motion& motion, double end, int least_onsets) {
  ASSERT_TRUE(motion.began);
  int n_onsets = 0;
  while (motion.integrator.time() < end) {
    ASSERT_TRUE(motion.integrator.advance(end));
    const auto changing = motion.integrator.changing_contact();
    for (std::size_t k = 0; k < motion.integrator.gaps().size(); ++k) {
      const bool open = !motion.integrator.equations().latches[k].in_contact;
      const ContactGap gap = motion.find_contact_gap(k);
      if (open) {
        ASSERT_LE(gap.penetration, 0.0) << motion.integrator.time();
      }
      // The gaps handed out are those of the state, to the rounding of coordinates near one metre.
      ASSERT_NEAR(motion.integrator.gaps()[k].penetration, gap.penetration, 1e-15) << motion.integrator.time();
      if (changing != k || !open) continue;
      ++n_onsets;
      ASSERT_GE(gap.penetration, -kOnsetTime * gap.penetration_rate - 1e-15) << motion.integrator.time();
    }
  }
  EXPECT_GE(n_onsets, least_onsets);
}

TEST(MotionIntegrator, NoEntryIsPenetratedInThePress) {
  Motion motion(oracle::make_nine_bar(), {});
  expect_contract(motion, 0.3, 20);
}

// Loose steps whose dense output sees separations that the solution does not make, and closures that want projection
// where contacts change.
TEST(MotionIntegrator, NoEntryIsPenetratedByLooseSteps) {
  for (const double absolute : {1e-9, 1e-12}) {
    Study study;
    study.relative_tolerance = 1e-4;
    study.absolute_tolerance = absolute;
    Motion motion(oracle::make_nine_bar(), study);
    expect_contract(motion, 0.7, 20);
    EXPECT_GT(motion.integrator.statistics().projections, 0);
  }
}

TEST(MotionIntegrator, NoEntryIsPenetratedInTheWornPress) {
  Motion motion(oracle::make_nine_bar(), {});
  std::vector<double> depths(1000);
  for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = 2e-5 * (1.0 + std::sin(0.7 * static_cast<double>(k)));
  for (std::size_t k = 0; k < 2; ++k) set_surfaces(motion.system, k, depths, {});
  expect_contract(motion, 0.2, 20);
}

// Corners and pins on both sides; worn sides with a wave of four regions, 3 mm, below them.
TEST(MotionIntegrator, NoEntryIsPenetratedInSlots) {
  for (const auto& [mechanism, n_corners] :
       {std::pair{oracle::make_slider_crank_guide(), 4}, {oracle::make_scotch_yoke_clearance(), 1}}) {
    for (const bool worn : {false, true}) {
      Motion motion(mechanism, {});
      if (worn) {
        std::vector<double> sides(800);
        for (std::size_t k = 0; k < sides.size(); ++k) sides[k] = 2e-5 * (1.0 + std::sin(1.6 * static_cast<double>(k)));
        set_surfaces(motion.system, 0, sides, std::vector<double>(static_cast<std::size_t>(400 * n_corners), 1e-6));
      }
      expect_contract(motion, 0.4, 8);
    }
  }
}

TEST(MotionIntegrator, InterpolatesBetweenTheStatesAtTheEnds) {
  Motion motion(oracle::make_nine_bar(), {});
  std::vector<double> before;
  std::vector<double> y(motion.integrator.y().size());
  for (int k = 0; k < 300; ++k) {
    before = motion.integrator.y();
    const double start = motion.integrator.time();
    ASSERT_TRUE(motion.integrator.advance(1.0));
    EXPECT_EQ(motion.integrator.time(), start + motion.integrator.last_step());
    motion.integrator.interpolate(start, y);
    for (std::size_t i = 0; i < y.size(); ++i) ASSERT_EQ(y[i], before[i]) << k;
    motion.integrator.interpolate(motion.integrator.time(), y);
    // The end of dense output is that before the projection, which moves states by less than the local tolerance.
    for (std::size_t i = 0; i < 10; ++i) {
      ASSERT_NEAR(y[i], motion.integrator.y()[i], 1e-9 + 1e-7 * std::abs(y[i])) << k;
    }
  }
}

TEST(MotionIntegrator, HoldsClosuresBelowTheTolerance) {
  Study study;
  Motion motion(oracle::make_four_bar(), study);
  while (motion.integrator.time() < 1.0) {
    ASSERT_TRUE(motion.integrator.advance(1.0));
    ASSERT_LE(find_largest(motion.integrator.equations().workspace.closure_gap), study.absolute_tolerance);
  }
  EXPECT_GT(motion.integrator.statistics().projections, 0);
}

TEST(MotionIntegrator, StridesOverSingularPositions) {
  Study study;
  study.relative_tolerance = study.absolute_tolerance = 1e-10;
  Motion motion(oracle::make_n_four_bar(1), study, 10.0);
  int n_strides = 0;
  std::vector<double> y(motion.integrator.y().size());
  while (motion.integrator.time() < 2.0) {
    const std::vector<double> before = motion.integrator.y();
    const double start = motion.integrator.time();
    ASSERT_TRUE(motion.integrator.advance(2.0));
    if (motion.integrator.last_step() > 0.0) continue;
    ++n_strides;
    motion.integrator.interpolate(start, y);
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], before[i], 1e-12) << "where the stride began";
    motion.integrator.interpolate(motion.integrator.time(), y);
    // Projection may move the far side by what the stride is trusted to, a hundred tolerances of angles up to 6.
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(y[i], motion.integrator.y()[i], 1e-7);
  }
  EXPECT_GE(n_strides, 1);
}

// So tight a tolerance asks for more digits than slopes beside a singular position of 40 loops have: there the step
// fell below the smallest. Neither that nor the wrong branch, whose energy is right as well.
TEST(MotionIntegrator, StridesOverSingularPositionsOfManyLoopsAtTheTightestTolerance) {
  const auto find_first_angle = [](double tolerance) {
    Study study;
    study.relative_tolerance = tolerance;
    study.absolute_tolerance = 0.01 * tolerance;
    Motion motion(oracle::make_n_four_bar(40), study, 1.0);
    while (motion.integrator.time() < 2.0 && motion.integrator.advance(2.0)) {
    }
    return motion.integrator.time() == 2.0 ? motion.integrator.y().front() : std::nan("");
  };
  EXPECT_NEAR(find_first_angle(1e-12), find_first_angle(1e-10), 1e-7);
}

TEST(MotionIntegrator, FailsAtASingularStart) {
  Mechanism mechanism = oracle::make_n_four_bar(2);
  for (Body& body : mechanism.bodies) {
    if (body.name.starts_with("post")) body.start = oracle::start_at(0.0);
  }
  EXPECT_FALSE(Motion(mechanism, {}).began);
}

// A crank driven on beyond the position where the loop is stretched: no step leads there.
TEST(MotionIntegrator, StopsWhereTheLoopCannotFollow) {
  Mechanism mechanism = oracle::make_four_bar();
  mechanism.loads.clear();
  mechanism.bodies[1].start = {};
  mechanism.bodies[0].points[1].position = {0.55, 0.11};
  mechanism.bodies[2].start = oracle::start_at(-0.3);
  mechanism.bodies[3].start = oracle::start_at(2.4);
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.3, 1.0});
  Motion motion(mechanism, {});
  ASSERT_TRUE(motion.began);
  int n_steps = 0;
  while (motion.integrator.time() < 3.0 && motion.integrator.advance(3.0)) ASSERT_LT(++n_steps, 100000);
  EXPECT_LT(motion.integrator.time(), 3.0);
  EXPECT_GT(motion.integrator.time(), 0.1);
  for (const double value : motion.integrator.y()) EXPECT_TRUE(std::isfinite(value));
  EXPECT_LT(motion.integrator.statistics().closure_residual, 1e-6);
}

}  // namespace
}  // namespace gudgeon
