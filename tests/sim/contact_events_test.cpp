// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of contact within one step, against the closed forms of flights that are straight or parabolas.
#include "gudgeon/sim/contact_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/sim/attempted_step.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

// Dense output is exact for parabolas, so that times are good to the root-finder's 45 bits and some rounding.
constexpr double kTimeTolerance = 1e-12;

// Straight up, against gravity: the gap is widest when the ball is highest, and the centre then at `height`.
Attempt throw_up(double height, double gravity = 4.0) {
  const Vec2 velocity{0.0, std::sqrt(2.0 * gravity * (height - 0.1))};
  return Attempt(make_balls({{{0.0, 0.1}, velocity}}, {0.0, -gravity}, kNoStiffness));
}

TEST(ContactEvents, GapsAreThoseOfTheSurfaces) {
  Attempt attempt(make_balls({{{0.12, -0.16}, {0.9, 0.2}, 3.0}}, {}, kNoStiffness));
  attempt.find_change(1e-3);
  const GapState& gap = attempt.start[0];
  EXPECT_NEAR(gap.penetration, 0.2 - kBallClearance, 1e-15);  // roundings of numbers below one
  EXPECT_NEAR(gap.reach, gap.penetration, 1e-15);
  EXPECT_NEAR(gap.penetration_rate, 0.6 * 0.9 - 0.8 * 0.2, 1e-15);
  EXPECT_EQ(gap.reach_rate, gap.penetration_rate);
  EXPECT_EQ(gap.cell_rate, 0.0);
  // The line of centres turns at (e × ė)/e² = 4.2 rad/s against the bearing, 1.2 rad/s against the ball.
  set_surfaces(attempt.system, 0, {}, std::vector<double>(100, 1e-3));
  attempt.find_change(1e-3);
  EXPECT_NEAR(attempt.start[0].cell_rate, 4.2 * 100.0 / (2.0 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(attempt.start[0].reach, 0.2 - kBallClearance - 1e-3, 1e-15);
}

TEST(ContactEvents, OnsetOfObliqueFlight) {
  const Vec2 x{0.1, -0.2};
  const Vec2 v{1.3, 0.7};
  const double half = dot(x, v) / dot(v, v);
  const double onset = -half + std::sqrt(half * half - (dot(x, x) - 0.25) / dot(v, v));
  for (const double h : {1.001 * onset, 2.0 * onset, 0.6}) {
    const auto change = Attempt(make_balls({{x, v}}, {}, kNoStiffness)).find_change(h);
    ASSERT_TRUE(change) << h;
    EXPECT_EQ(change->contact, 0U);
    EXPECT_NEAR(change->share * h, onset, kTimeTolerance);
  }
  EXPECT_FALSE(Attempt(make_balls({{x, v}}, {}, kNoStiffness)).find_change(0.999 * onset));
}

TEST(ContactEvents, TouchThatIsOverWithinTheStepIsSeen) {
  for (const double depth : {1e-2, 1e-5, 1e-9}) {
    Attempt attempt = throw_up(kBallClearance + depth);
    const double top = std::sqrt(2.0 * 4.0 * (0.4 + depth)) / 4.0;
    for (const double h : {1.3 * top, 1.9 * top}) {
      const auto change = attempt.find_change(h);
      ASSERT_LT(attempt.end[0].penetration, 0.0) << "left again";
      ASSERT_TRUE(change) << depth;
      // Where the gap is flat, its rounding is felt over ė. Dense output sums terms of up to 10 m: 4e-15 m.
      EXPECT_NEAR(change->share * h, top - std::sqrt(depth / 2.0), kTimeTolerance + 4e-15 / std::sqrt(8.0 * depth));
    }
  }
}

// Inwards first, then over the rim of the bearing and back: the gap shrinks at both ends of the step.
TEST(ContactEvents, TouchOnAWindingFlightIsSeen) {
  const Vec2 start{-0.3, 0.05};
  const Vec2 velocity{3.0, 10.0};
  const double gravity = 100.0;
  const auto find_eccentricity = [&](double t) {
    return norm(start + t * velocity - Vec2{0.0, 0.5 * gravity * t * t});
  };
  double before = 0.0;
  double after = 0.1;  // at its highest, over the rim
  ASSERT_GT(find_eccentricity(after), kBallClearance);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (before + after);
    (find_eccentricity(middle) > kBallClearance ? after : before) = middle;
  }
  for (const double h : {0.14, 0.15, 0.16}) {
    Attempt attempt(make_balls({{start, velocity}}, {0.0, -gravity}, kNoStiffness));
    const auto change = attempt.find_change(h);
    ASSERT_LT(attempt.start[0].penetration_rate, 0.0);
    ASSERT_LT(attempt.end[0].penetration_rate, 0.0);
    ASSERT_LT(attempt.end[0].penetration, 0.0);
    ASSERT_TRUE(change) << h;
    EXPECT_NEAR(change->share * h, before, kTimeTolerance);
  }
}

TEST(ContactEvents, ComingNearIsNotTouching) {
  for (const double distance : {1e-2, 1e-6, 1e-12}) {
    Attempt attempt = throw_up(kBallClearance - distance);
    const double top = std::sqrt(2.0 * 4.0 * (0.4 - distance)) / 4.0;
    for (const double h : {0.9 * top, top, 1.9 * top}) EXPECT_FALSE(attempt.find_change(h)) << distance;
  }
}

TEST(ContactEvents, Separation) {
  Attempt attempt(make_balls({{{0.51, 0.0}, {-0.4, 0.0}}}, {}, kNoStiffness));
  attempt.equations.contact_modes[0] = {true, 0.4};
  for (const double h : {0.026, 0.1}) {
    const auto change = attempt.find_change(h);
    ASSERT_TRUE(change);
    EXPECT_NEAR(change->share * h, 0.01 / 0.4, kTimeTolerance);
  }
  EXPECT_FALSE(attempt.find_change(0.024)) << "still in contact";
}

TEST(ContactEvents, SeparationThatIsOverWithinTheStepIsSeen) {
  // Falls from 0.51 away from the wall, pulled back by 8 m/s²: e = 0.51 − v t + 4 t², at least 0.51 − v²/16.
  for (const double lowest : {0.49, 0.5 + 1e-9}) {
    const double v = std::sqrt(16.0 * (0.51 - lowest));
    Attempt attempt(make_balls({{{0.51, 0.0}, {-v, 0.0}}}, {8.0, 0.0}, kNoStiffness));
    attempt.equations.contact_modes[0] = {true, v};
    const double h = 1.9 * v / 8.0;
    const auto change = attempt.find_change(h);
    ASSERT_GT(attempt.end[0].penetration, 0.0) << "touches again";
    ASSERT_EQ(change.has_value(), lowest < 0.5);
    if (!change) continue;
    EXPECT_NEAR(change->share * h, (v - std::sqrt(v * v - 16.0 * 0.01)) / 8.0, kTimeTolerance);
  }
}

TEST(ContactEvents, TheEarlierOfTwoWins) {
  const BallFlight late{{0.0, 0.0}, {1.0, 0.0}};
  const BallFlight early{{0.0, 0.2}, {0.0, 1.0}};
  for (const bool early_first : {true, false}) {
    const std::vector<BallFlight> flights = early_first ? std::vector{early, late} : std::vector{late, early};
    const auto change = Attempt(make_balls(flights, {}, kNoStiffness)).find_change(0.8);
    ASSERT_TRUE(change);
    EXPECT_EQ(change->contact, early_first ? 0U : 1U);
    EXPECT_NEAR(change->share * 0.8, 0.3, kTimeTolerance);
  }
}

TEST(ContactEvents, SeparationOfOneBeforeOnsetOfTheOther) {
  Attempt attempt(make_balls({{{0.0, 0.0}, {1.0, 0.0}}, {{0.0, 0.51}, {0.0, -0.1}}}, {}, kNoStiffness));
  attempt.equations.contact_modes[1] = {true, 0.1};
  const auto change = attempt.find_change(0.8);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->contact, 1U);
  EXPECT_NEAR(change->share * 0.8, 0.1, kTimeTolerance);
}

// A ball worn all around but for one cell, which spins without moving: the ridge sweeps over the bearing.
class WornBall : public testing::Test {
 protected:
  static constexpr std::size_t kCells = 1000;
  static constexpr double kDepth = 0.01;
  static constexpr double kSpin = -2.0;  // [rad/s]: the line of centres, along x, passes the ball's cells in order

  static std::vector<double> make_ridge(std::size_t cell) {
    std::vector<double> depths(kCells, kDepth);
    depths[cell] = 0.0;
    return depths;
  }

  // The centre stands at the clearance and this much of the wear; the ridge's top is at a third of it.
  static Mechanism make_ball(double share) {
    return make_balls({{{kBallClearance + share * kDepth, 0.0}, {}, kSpin}}, {}, kNoStiffness);
  }
};

TEST_F(WornBall, RidgePassedWithinTheStepIsSeen) {
  // Steps of a quarter turn and more; eighths of the step would see nothing of a ridge two cells wide.
  for (const std::size_t cell : {53U, 97U, 171U}) {
    Attempt attempt(make_ball(0.5));
    set_surfaces(attempt.system, 0, {}, make_ridge(cell));
    const double h = 0.25 * 2.0 * std::numbers::pi / -kSpin;
    const auto change = attempt.find_change(h);
    ASSERT_LT(attempt.start[0].penetration, 0.0);
    ASSERT_LT(attempt.end[0].penetration, 0.0);
    ASSERT_TRUE(change) << cell;
    // There the depth is what the centre has moved out: the ridge's near flank.
    const double angle = -kSpin * change->share * h;
    const RadialProfile::Value at = RadialProfile(make_ridge(cell)).eval(angle);
    EXPECT_NEAR(at.depth, 0.5 * kDepth, 1e-12);
    EXPECT_LT(at.slope, 0.0) << "entered, not left";
    EXPECT_NEAR(angle * kCells / (2.0 * std::numbers::pi), static_cast<double>(cell) + 0.5, 1.5);
  }
}

// However many cells pass, only where the surfaces come near each other are they looked at one by one.
TEST_F(WornBall, ARidgeAmongManyMoreCellsIsFoundByFewLooks) {
  for (const std::size_t finer : {1U, 10U, 100U, 1000U}) {
    std::vector<double> depths(finer * kCells, kDepth);
    const std::size_t cell = 97 * finer;
    depths[cell] = 0.0;
    Attempt attempt(make_ball(0.5));
    set_surfaces(attempt.system, 0, {}, depths);
    const double h = 0.25 * 2.0 * std::numbers::pi / -kSpin;
    const auto change = attempt.find_change(h);
    ASSERT_TRUE(change) << finer;
    const double angle = -kSpin * change->share * h;
    EXPECT_NEAR(angle * static_cast<double>(depths.size()) / (2.0 * std::numbers::pi), static_cast<double>(cell) + 0.5,
                1.5);
    EXPECT_LT(attempt.n_looks, 250) << finer;
    // Nor over a pocket wherein the ball does not come near anything.
    std::ranges::fill(depths, kDepth);
    depths[depths.size() / 2] = 0.0;
    set_surfaces(attempt.system, 0, {}, depths);
    EXPECT_FALSE(attempt.find_change(h));
    EXPECT_LT(attempt.n_looks, 20) << finer;
  }
}

TEST_F(WornBall, RidgeThatIsTooLowIsNotTouched) {
  Attempt attempt(make_ball(0.33));
  set_surfaces(attempt.system, 0, {}, make_ridge(97));
  EXPECT_FALSE(attempt.find_change(0.25 * 2.0 * std::numbers::pi / -kSpin));
}

TEST_F(WornBall, FirstOfTwoRidgesWins) {
  std::vector<double> depths(kCells, kDepth);
  depths[61] = depths[62] = depths[150] = 0.0;
  Attempt attempt(make_ball(0.5));
  set_surfaces(attempt.system, 0, {}, depths);
  const auto change = attempt.find_change(0.6);
  ASSERT_TRUE(change);
  EXPECT_NEAR(change->share * 1.2 * kCells / (2.0 * std::numbers::pi), 61.0, 1.0);
}

}  // namespace
}  // namespace gudgeon
