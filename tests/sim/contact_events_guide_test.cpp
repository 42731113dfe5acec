// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Changes of contact of a block in its slot within one step: tilted corners, both at once, ridges of worn sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/oracle/mechanisms.h"
#include "tests/sim/attempted_step.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

// Where the block's corners are: centres 45 and 20 mm from its middle, 5 mm round, sides 26 mm from the slot's middle.
constexpr double kAhead = 45e-3;
constexpr double kAside = 20e-3;
constexpr double kFree = 21e-3;  // [m] a corner's centre from the slot's middle when it touches

Mechanism make_flight(const BodyStart& start, Vec2 gravity = {}) {
  Mechanism mechanism = oracle::make_loose_block(start, kNoStiffness);
  mechanism.gravity = gravity;
  return mechanism;
}

BodyStart fly(Vec2 position, Vec2 velocity, double angle, double angle_rate) {
  BodyStart start;
  start.angle = angle;
  start.angle_rate = angle_rate;
  start.position = position;
  start.velocity = velocity;
  return start;
}

// A root between 0 and end of a function that rises there once, by halving.
double halve(const std::function<double(double)>& f, double end) {
  double low = 0.0;
  double high = end;
  for (int k = 0; k < 60; ++k) (f(0.5 * (low + high)) > 0.0 ? high : low) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

TEST(GuideEvents, GapsAreThoseOfTheCorners) {
  Attempt step(make_flight(fly({0.01, 1e-4}, {0.3, 0.05}, 2e-3, 0.4)));
  step.find_change(1e-3);
  ASSERT_EQ(step.start.size(), 4U);
  int k = 0;
  for (const double side : {1.0, -1.0}) {
    for (const double ahead : {-kAhead, kAhead}) {
      const double c = std::cos(2e-3);
      const double s = std::sin(2e-3);
      const GapState& gap = step.start[k++];
      const double height = side * (1e-4 + ahead * s + side * kAside * c);
      EXPECT_NEAR(gap.penetration, height - kFree, 1e-16);
      EXPECT_NEAR(gap.penetration_rate, side * (0.05 + 0.4 * (ahead * c - side * kAside * s)), 1e-15);
      EXPECT_EQ(gap.reach, gap.penetration);
      EXPECT_EQ(gap.cell_rate, 0.0);
      EXPECT_NEAR(gap.overrun, std::abs(0.01 + ahead * c - side * kAside * s) - 0.5, 1e-15);
    }
  }
  // 500 cells of 2 mm pass at the speed of the corner, 100 around a corner at the block's spin.
  set_surfaces(step.system, 0, std::vector<double>(1000, 3e-5), std::vector<double>(400, 2e-5));
  step.find_change(1e-3);
  const double corner_speed = 0.3 - 0.4 * (kAhead * std::sin(2e-3) + kAside * std::cos(2e-3));
  EXPECT_NEAR(step.start[1].cell_rate, corner_speed * 500.0, 1e-9);
  EXPECT_NEAR(step.start[1].reach, step.start[1].penetration, 1e-16) << "worn evenly: the bound is the gap";
  set_surfaces(step.system, 0, {}, std::vector<double>(40000, 2e-5));
  step.find_change(1e-3);
  EXPECT_NEAR(step.start[1].cell_rate, 0.4 * 10000.0 / (2.0 * std::numbers::pi), 1e-9);
}

// Sines are no polynomials, but the block turns by 0.01 at most, and coordinates are straight in time.
TEST(GuideEvents, OnsetOfATiltedCorner) {
  struct Flight {
    BodyStart start;
    std::size_t contact;
    double side;
    double ahead;
  };
  for (const Flight& flight : {Flight{fly({0.01, 1e-4}, {0.3, 0.05}, 2e-3, 0.4), 1, 1.0, kAhead},
                               Flight{fly({0.01, 1e-4}, {0.3, 0.05}, -2e-3, -0.4), 0, 1.0, -kAhead},
                               Flight{fly({0.01, -1e-4}, {0.3, -0.05}, 2e-3, 0.4), 2, -1.0, -kAhead},
                               Flight{fly({0.01, -1e-4}, {0.3, -0.05}, -2e-3, -0.4), 3, -1.0, kAhead}}) {
    const auto gap = [&](double t) {
      const double angle = *flight.start.angle + *flight.start.angle_rate * t;
      const double y = flight.start.position->y + flight.start.velocity->y * t;
      return flight.side * (y + flight.ahead * std::sin(angle)) + kAside * std::cos(angle) - kFree;
    };
    const double onset = halve(gap, 0.02);
    for (const double h : {1.001 * onset, 0.02}) {
      const auto change = Attempt(make_flight(flight.start)).find_change(h);
      ASSERT_TRUE(change) << flight.contact;
      EXPECT_EQ(change->contact, flight.contact);
      EXPECT_NEAR(change->share * h, onset, 1e-12);  // the root-finder's 45 bits
    }
    EXPECT_FALSE(Attempt(make_flight(flight.start)).find_change(0.999 * onset));
  }
}

TEST(GuideEvents, TouchOfBothCornersThatIsOverWithinTheStepIsSeen) {
  for (const double depth : {1e-5, 1e-9}) {
    const double speed = std::sqrt(2.0 * 4.0 * (1e-3 + depth));
    Attempt step(make_flight(fly({0.0, 0.0}, {0.0, speed}, 0.0, 0.0), {0.0, -4.0}));
    const double top = speed / 4.0;
    const auto change = step.find_change(1.9 * top);
    ASSERT_LT(step.end[0].penetration, 0.0) << "left again";
    ASSERT_TRUE(change) << depth;
    // Where the gap is flat, rounding of the gap (1e-17 m) is felt as 1e-17/δ̇.
    EXPECT_NEAR(change->share * 1.9 * top, top - std::sqrt(depth / 2.0), 1e-12 + 1e-16 / std::sqrt(8.0 * depth));
  }
}

// The left side worn all along but for one cell of 1 mm; the block slides at half of the depth beyond its clearance.
class WornSide : public testing::Test {
 protected:
  static constexpr double kDepth = 1e-4;

  static std::vector<double> make_ridge(std::size_t cell) {
    std::vector<double> depths(1000, kDepth);
    depths[cell] = 0.0;
    return depths;
  }
  static Mechanism make_slide(double share) {
    return make_flight(fly({0.0, 1e-3 + share * kDepth}, {0.4, 0.0}, 0.0, 0.0));
  }
  static void wear_left(Attempt& step, std::size_t cell) {
    std::vector<double> both = make_ridge(cell);
    both.resize(2000, kDepth);
    set_surfaces(step.system, 0, both, {});
  }
};

TEST_F(WornSide, RidgePassedWithinTheStepIsSeen) {
  // 40 cells a step; eighths of it would see nothing of a ridge two cells wide. The front corner stands at 545.
  for (const std::size_t cell : {553U, 571U, 584U}) {
    Attempt step(make_slide(0.5));
    wear_left(step, cell);
    const auto change = step.find_change(0.1);
    ASSERT_LT(step.start[1].penetration, 0.0);
    ASSERT_LT(step.end[1].penetration, 0.0);
    ASSERT_TRUE(change) << cell;
    EXPECT_EQ(change->contact, 1U);
    const double position = kAhead + 0.4 * change->share * 0.1;
    const LineProfile::Value at = LineProfile(make_ridge(cell), 1.0).eval(position);
    EXPECT_NEAR(at.depth, 0.5 * kDepth, 1e-14);
    EXPECT_LT(at.slope, 0.0) << "entered, not left";
    EXPECT_NEAR(1e3 * (position + 0.5), static_cast<double>(cell) + 0.5, 1.5);
  }
}

TEST_F(WornSide, RidgeThatIsTooLowIsNotTouched) {
  Attempt step(make_slide(0.33));
  wear_left(step, 571);
  EXPECT_FALSE(step.find_change(0.1));
}

TEST_F(WornSide, RidgeOfTheOtherSideIsNotTouched) {
  Attempt step(make_slide(0.5));
  std::vector<double> both(1000, kDepth);
  const std::vector<double> ridge = make_ridge(571);
  both.insert(both.end(), ridge.begin(), ridge.end());
  set_surfaces(step.system, 0, both, {});
  EXPECT_FALSE(step.find_change(0.1));
}

}  // namespace
}  // namespace gudgeon
