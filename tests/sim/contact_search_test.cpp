// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What dense output alone does not tell: dips that a cubic misses, and gaps that only the shorter step closes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/sim/attempted_step.h"
#include "tests/sim/flying_ball.h"
#include "tests/sim/integrated_motion.h"

namespace gudgeon {
namespace {

// A journal off the middle of a spinning ball comes nearest to the bearing's centre once a turn: e² = s² + ρ² − 2 s ρ
// cos θ, θ the angle from there. Between ends half a radian to either side e dips deeper than the cubic through its
// values and rates at the ends, by s ρ/(s − ρ) θ⁴/24 = 0.7 mm.
TEST(ContactSearch, APartingThatTheCubicMissesIsSeen) {
  constexpr double kOffset = 0.2;
  constexpr double kHalf = 0.5;
  for (const double dip : {1e-6, 1e-4, 4e-4}) {
    const double middle = kBallClearance - dip + kOffset;
    Mechanism mechanism = make_balls({{{0.0, middle}, {}, 1.0}}, {}, kNoStiffness);
    mechanism.bodies[1].points[0].position = {kOffset, 0.0};
    mechanism.bodies[1].start.angle = -0.5 * std::numbers::pi - kHalf;
    Attempt attempt(mechanism);
    attempt.equations.contact_modes[0] = {true, 1.0};
    const auto change = attempt.find_change(2.0 * kHalf);
    ASSERT_GT(attempt.start[0].penetration, 0.0);
    ASSERT_GT(attempt.end[0].penetration, 0.0);
    ASSERT_TRUE(change) << dip;
    const double cosine =
        (middle * middle + kOffset * kOffset - kBallClearance * kBallClearance) / (2.0 * middle * kOffset);
    EXPECT_NEAR(change->share * 2.0 * kHalf, kHalf - std::acos(cosine), 1e-9) << dip;
  }
}

// One ball flies straight into a soft wall and back, the other on a spring, which loose dense output knows less well
// than a step's end. Where a step would stride over the touch of the second, the one that is shortened to where the
// first touches or leaves can be the first to show it.
TEST(ContactSearch, AGapThatOnlyTheShorterStepClosesIsNotPassed) {
  constexpr double kFrequency = 20.0;  // [rad/s]
  Study study;
  study.integrator = Integrator::explicit_pair;
  study.relative_tolerance = study.absolute_tolerance = 0.1;
  for (const double speed : {11.0, 12.0, 14.0}) {
    // x = 0.1 cos ωt + v/ω sin ωt comes to the wall.
    const double amplitude = std::hypot(0.1, speed / kFrequency);
    const double touch = (std::asin(kBallClearance / amplitude) - std::asin(0.1 / amplitude)) / kFrequency;
    for (int k = 0; k <= 320; ++k) {
      const double late = 0.75 + 1.25e-3 * k;
      Mechanism mechanism =
          make_balls({{{0.1, 0.0}, {0.4 / (touch * late), 0.0}}, {{0.1, 0.0}, {speed, 0.0}}}, {}, 1e6);
      mechanism.loads.push_back(
          {"spring",
           Spring{{kFrameName, "bearing_1"}, {"ball_1", "journal"}, 2.0 * kFrequency * kFrequency, 0.0, 0.0}});
      IntegratedMotion motion(mechanism, study, 100.0);
      while (motion.integrator.time() < 1.2 * touch) {
        ASSERT_TRUE(motion.integrator.advance(1.2 * touch));
        for (std::size_t contact = 0; contact < 2; ++contact) {
          if (motion.integrator.equations().contact_modes[contact].in_contact) continue;
          ASSERT_LE(motion.find_contact_gap(contact).penetration, 0.0) << speed << ", " << late << ": " << contact;
        }
      }
      EXPECT_EQ(motion.integrator.statistics().onsets, 2) << speed << ", " << late;
    }
  }
}

}  // namespace
}  // namespace gudgeon
