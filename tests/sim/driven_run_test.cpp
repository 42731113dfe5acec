// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whole motions with accelerating drivers, drivers between bodies and pins in slots; and a thrown body.
#include <gtest/gtest.h>

#include "gudgeon/sim/motion_integrator.h"
#include "gudgeon/system/body_motion.h"
#include "tests/oracle/driver_motion.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

struct FinishedMotion {
  FinishedMotion(const Mechanism& mechanism, Study settings, double end)
      : study(settings),
        assembly(assemble(mechanism)),
        system(compile(mechanism, assembly)),
        integrator(system, study, 1.0),
        finder(system) {
    EXPECT_TRUE(integrator.begin(make_state(system, assembly))) << mechanism.name;
    start_energy = find_energy();
    while (integrator.time() < end) {
      if (!integrator.advance(end)) {
        ADD_FAILURE() << mechanism.name << " stops at " << integrator.time();
        break;
      }
    }
  }

  double find_energy() {
    const Workspace& workspace = integrator.equations().workspace;
    finder.update(workspace);
    return find_kinetic_energy(system.mechanism, finder.motions()) +
           find_potential_energy(system.tables, workspace.coordinates);
  }

  Study study;
  Assembly assembly;
  System system;
  MotionIntegrator integrator;
  BodyMotionFinder finder;
  double start_energy = 0.0;
};

Study make_study() {
  Study study;
  study.relative_tolerance = 1e-10;
  study.absolute_tolerance = 1e-12;
  return study;
}

TEST(DrivenRun, GainsTheEnergyThatItsDriversDeliver) {
  for (const Mechanism& mechanism :
       {oracle::make_swung_slider_crank(), oracle::make_driven_arm(false), oracle::make_driven_arm(true),
        oracle::make_scotch_yoke(), oracle::make_quick_return(), oracle::make_trammel(), oracle::make_moved_slides(),
        oracle::make_splined_slide()}) {
    FinishedMotion run(mechanism, make_study(), 0.7);
    const std::size_t n = run.integrator.equations().n_free();
    const double work = run.integrator.y()[2 * n + kDriverWork];
    EXPECT_NEAR(run.find_energy() - run.start_energy, work, 1e-8) << mechanism.name;
    for (const Vec2 gap : run.integrator.equations().workspace.closure_gap) {
      EXPECT_NEAR(norm(gap), 0.0, 1e-12) << mechanism.name;
    }
  }
}

TEST(DrivenRun, RelativeAngleIsHeldAllTheWay) {
  const Mechanism mechanism = oracle::make_driven_arm(false);
  FinishedMotion run(mechanism, make_study(), 0.9);
  const auto asked = oracle::eval_motion(mechanism.drivers[0], 0.9);
  run.find_energy();
  const BodyMotion& arm = run.finder.motions()[1];
  const BodyMotion& hand = run.finder.motions()[3];
  EXPECT_NEAR(hand.angle - arm.angle, asked.value, 1e-12);
  EXPECT_NEAR(hand.angle_rate - arm.angle_rate, asked.rate, 1e-10);
}

TEST(DrivenRun, ProjectileFliesItsParabola) {
  const Mechanism mechanism = oracle::make_projectile();
  FinishedMotion run(mechanism, {}, 2.0);
  run.find_energy();
  const BodyMotion& body = run.finder.motions()[1];
  const Vec2 arm = make_rotation(0.4) * mechanism.bodies[1].center_of_mass;
  const Vec2 position = Vec2{0.3, -0.2} + arm;
  const Vec2 velocity = Vec2{2.5, 4.0} - 7.0 * perp(arm);
  const Vec2 g = mechanism.gravity;
  EXPECT_NEAR(norm(body.position - (position + 2.0 * velocity + 2.0 * g)), 0.0, 1e-10);
  EXPECT_NEAR(norm(body.velocity - (velocity + 2.0 * g)), 0.0, 1e-10);
  EXPECT_NEAR(body.angle, 0.4 - 14.0, 1e-10);
  EXPECT_NEAR(body.angle_rate, -7.0, 1e-12);
}

}  // namespace
}  // namespace gudgeon
