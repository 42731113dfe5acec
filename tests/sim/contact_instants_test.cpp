// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts that last for an instant, or for none: surfaces that graze, that all but meet, that leave and come back.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"
#include "tests/sim/flying_ball.h"
#include "tests/sim/integrated_motion.h"

namespace gudgeon {
namespace {

constexpr double kGravity = 4.0;

// Thrown up so as to come this far beyond the clearance, were there no wall.
Mechanism make_graze(double depth, double sideways, double gravity, double young_modulus) {
  const double low = 0.1;
  // The highest point of the flight is above the middle of the bearing.
  const double rise = kBallClearance + depth - low;
  const double speed = std::sqrt(2.0 * gravity * rise);
  const double time = speed / gravity;
  return make_balls({{{-sideways * time, low}, {sideways, speed}}}, {0.0, -gravity}, young_modulus);
}

Study make_study(Integrator integrator, double tolerance) {
  Study study;
  study.integrator = integrator;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-9;
  return study;
}

// A ball that spins about its middle, its journal off it: once a turn the journal comes this far beyond the clearance.
// Coordinates are straight in time, so that every integrator knows where it is to rounding; the surfaces are so soft
// that nothing is felt.
Mechanism make_spun_journal(double depth, double start_angle, double spin) {
  constexpr double kOffset = 0.2;
  Mechanism mechanism = make_balls({{{0.0, kBallClearance + depth - kOffset}, {}, spin}}, {}, kNoStiffness);
  mechanism.bodies[1].points[0].position = {kOffset, 0.0};
  mechanism.bodies[1].start.angle = start_angle;
  return mechanism;
}

TEST(ContactInstants, GrazesAreFoundByEveryIntegrator) {
  for (const Integrator integrator : {Integrator::explicit_pair, Integrator::automatic, Integrator::stiff}) {
    for (const double depth : {1e-9, 1e-8, 1e-7}) {
      for (const double start_angle : {-1.0, -0.3, 0.2, 0.7, 1.1, 1.4, 1.5, 1.57}) {
        IntegratedMotion motion(make_spun_journal(depth, start_angle, 1.0), make_study(integrator, 1e-3), 40.0);
        ASSERT_TRUE(motion.began);
        while (motion.integrator.time() < 4.0) ASSERT_TRUE(motion.integrator.advance(4.0));
        const std::string where = std::to_string(static_cast<int>(integrator)) + ' ' + std::to_string(1e9 * depth) +
                                  " nm from " + std::to_string(start_angle);
        EXPECT_EQ(motion.integrator.statistics().onsets, 1) << where;
        EXPECT_EQ(motion.integrator.statistics().separations, 1) << where;
      }
    }
  }
}

// Depths about nothing at all, on both sides: a touch at one instant, or a contact that is met a hair open and turns
// back. Neither stops a run, and none is entered unseen.
TEST(ContactInstants, TouchesOfNoDepthGoOn) {
  for (const Integrator integrator : {Integrator::explicit_pair, Integrator::automatic, Integrator::stiff}) {
    for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
      for (const double gravity : {4.0, 1e-2, 1e-6}) {
        for (const double depth : {-1e-13, -1e-15, -1e-16, 0.0, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11}) {
          IntegratedMotion motion(make_graze(depth, 0.0, gravity, 1e6), make_study(integrator, tolerance),
                                  1.0 / std::sqrt(gravity));
          const double end = 0.8 / std::sqrt(gravity);
          const std::string where = std::to_string(static_cast<int>(integrator)) + " at " + std::to_string(tolerance) +
                                    ", gravity " + std::to_string(gravity) + ", " + std::to_string(1e15 * depth) +
                                    " fm";
          while (motion.integrator.time() < end) {
            ASSERT_TRUE(motion.integrator.advance(end)) << where << " at " << motion.integrator.time();
            const bool open = !motion.integrator.equations().contact_modes[0].in_contact;
            if (open) {
              ASSERT_LE(motion.find_contact_gap(0).penetration, 2e-16) << where;
            }
          }
          EXPECT_EQ(motion.integrator.statistics().onsets, motion.integrator.statistics().separations) << where;
          EXPECT_LE(motion.integrator.statistics().onsets, 1) << where;
          EXPECT_LT(motion.integrator.statistics().accepted_steps, 400) << where;
        }
      }
    }
  }
}

// A contact mode that was switched a hair too early, as where surfaces approach at 0.1 mm/s and are drawn back at once.
TEST(ContactInstants, AContactThatNeverClosesEnds) {
  for (const double hair : {1e-9, 1e-11, 1e-13, 1e-15}) {
    for (const double speed : {1e-4, 1e-6, 1e-9}) {
      const Mechanism mechanism = make_balls({{{0.0, kBallClearance - hair}, {0.0, speed}}}, {0.0, -kGravity}, 1e9);
      IntegratedMotion motion(mechanism, {});
      motion.integrator.equations().contact_modes[0] = {true, speed};
      const bool touches = speed * speed > 2.0 * kGravity * hair;
      while (motion.integrator.time() < 0.1) ASSERT_TRUE(motion.integrator.advance(0.1)) << hair << ' ' << speed;
      EXPECT_FALSE(motion.integrator.equations().contact_modes[0].in_contact) << hair << ' ' << speed;
      EXPECT_EQ(motion.integrator.statistics().separations, 1) << hair << ' ' << speed << (touches ? " touches" : "");
    }
  }
}

// A block that is slowed down along its slot passes its end by this much, and comes back within a few milliseconds.
TEST(ContactInstants, ABlockThatLeavesItsSlotAndComesBackIsTold) {
  for (const double past : {-1e-6, 1e-9, 1e-6, 1e-4}) {
    BodyStart start;
    start.position = {0.0, 0.0};
    start.velocity = {std::sqrt(2.0 * (0.455 + past)), 0.0};
    Mechanism mechanism = oracle::make_loose_block(start, 1e9);
    mechanism.gravity = {-1.0, 0.0};
    Study study;
    study.cycle_time = 1.0;
    study.cycles = 1;
    study.compare_ideal = false;
    const auto stages = run_study(mechanism, study);
    ASSERT_EQ(stages.size(), 1U);
    EXPECT_EQ(stages[0].status, past < 0.0 ? StageStatus::finished : StageStatus::failed) << past;
    EXPECT_EQ(stages[0].message.find("E-NUM-005") == std::string::npos, past < 0.0) << stages[0].message;
  }
}

}  // namespace
}  // namespace gudgeon
