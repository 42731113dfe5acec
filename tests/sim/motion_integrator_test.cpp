// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The contract of a step: milestones, closures, dense output, singular positions.
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/sim/flying_ball.h"
#include "tests/sim/integrated_motion.h"

namespace gudgeon {
namespace {

// Steppers hold on to the equations of their integrator, and these to a system: neither may be moved or go before them.
static_assert(!std::is_move_constructible_v<MotionIntegrator>);
static_assert(std::is_constructible_v<MotionIntegrator, const System&, const Study&, double>);
static_assert(!std::is_constructible_v<MotionIntegrator, System, const Study&, double>);
static_assert(!std::is_constructible_v<MotionIntegrator, const System&, Study, double>);

TEST(MotionIntegrator, HitsMilestonesExactly) {
  IntegratedMotion motion(oracle::make_four_bar(), {});
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
  IntegratedMotion free(make_balls({{{}, {}}}, {}, kNoStiffness),
                        study);  // nothing moves: no error would stop its steps
  while (free.integrator.time() < 1.0) ASSERT_TRUE(free.integrator.advance(1.0));
  EXPECT_NEAR(free.integrator.statistics().largest_step, 0.02, 1e-15) << "a fiftieth of the cycle";
  study.max_step = 0.003;
  IntegratedMotion held(make_balls({{{}, {}}}, {}, kNoStiffness), study);
  while (held.integrator.time() < 1.0) ASSERT_TRUE(held.integrator.advance(1.0));
  EXPECT_NEAR(held.integrator.statistics().largest_step, 0.003, 1e-15);
}

TEST(MotionIntegrator, InterpolatesBetweenTheStatesAtTheEnds) {
  IntegratedMotion motion(oracle::make_nine_bar(), {});
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
  IntegratedMotion motion(oracle::make_four_bar(), study);
  while (motion.integrator.time() < 1.0) {
    ASSERT_TRUE(motion.integrator.advance(1.0));
    ASSERT_LE(find_largest(motion.integrator.equations().workspace.closure_gap), study.absolute_tolerance);
  }
  EXPECT_GT(motion.integrator.statistics().projections, 0);
}

TEST(MotionIntegrator, StridesOverSingularPositions) {
  Study study;
  study.relative_tolerance = study.absolute_tolerance = 1e-10;
  IntegratedMotion motion(oracle::make_n_four_bar(1), study, 10.0);
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
    IntegratedMotion motion(oracle::make_n_four_bar(40), study, 1.0);
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
  EXPECT_FALSE(IntegratedMotion(mechanism, {}).began);
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
  IntegratedMotion motion(mechanism, {});
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
