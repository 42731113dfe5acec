// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The oracle against closed forms and published motions, and its contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracle/driver_motion.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook_start.h"

namespace gudgeon::oracle {
namespace {

TEST(Textbook, GivesThePendulumItsClosedForm) {
  const Mechanism mechanism = make_pendulum_chain(1);
  const TextbookState start = find_start(mechanism);
  const TextbookSolution solution = Textbook(mechanism).solve(start, 0.0);
  const Body& bar = mechanism.bodies[1];
  const Vec2 arm = make_rotation(start.bodies[1].angle) * bar.center_of_mass;
  const double expected = bar.mass * cross(arm, mechanism.gravity) / (bar.inertia + bar.mass * dot(arm, arm));
  EXPECT_NEAR(solution.accelerations[1].angle, expected, 1e-12 * std::abs(expected));
  const double rate = start.bodies[1].angle_rate;
  const Vec2 pin = bar.mass * (expected * perp(arm) - rate * rate * arm - mechanism.gravity);
  EXPECT_NEAR(solution.reactions[0].force.x, pin.x, 1e-12);
  EXPECT_NEAR(solution.reactions[0].force.y, pin.y, 1e-12);
}

TEST(Textbook, NamesRedundantRows) {
  for (const Mechanism& mechanism : make_all_mechanisms()) {
    const int expected = mechanism.name == "parallelogram" ? 1 : 0;
    const Mechanism ideal = make_ideal(mechanism);
    EXPECT_EQ(Textbook(ideal).solve(find_start(ideal), 0.0).n_redundant_rows, expected) << mechanism.name;
  }
}

/// The state at the end of equal steps.
TextbookState run(const Textbook& textbook, double end, int steps) {
  TextbookState state = find_start(textbook.mechanism());
  for (int i = 0; i < steps; ++i) state = textbook.step_rk4(state, end * i / steps, end / steps);
  return state;
}

TEST(Textbook, KeepsTheEnergyOfAPendulumChain) {
  const Textbook textbook(make_pendulum_chain(5));
  const double before = textbook.eval_energy(find_start(textbook.mechanism())).total();
  EXPECT_NEAR(textbook.eval_energy(run(textbook, 0.5, 1000)).total(), before, 1e-8);
}

TEST(Textbook, KeepsTheEnergyOfLoadedLoops) {
  for (const Mechanism& mechanism : {make_four_bar(), make_five_bar(), make_six_bar_slide(), make_two_slides()}) {
    const Textbook textbook(mechanism);
    const double before = textbook.eval_energy(find_start(mechanism)).total();
    EXPECT_NEAR(textbook.eval_energy(run(textbook, 0.1, 500)).total(), before, 1e-7) << mechanism.name;
  }
}

TEST(Textbook, SwingsAsTheIftommPendulum) {
  const TextbookState end = run(Textbook(make_point_mass_pendulum()), 1.0, 1000);
  EXPECT_NEAR(end.bodies[1].center.x, 0.986291751, 2e-9);
  EXPECT_NEAR(end.bodies[1].center.y, -0.165010853, 2e-9);
}

TEST(Textbook, MovesAsTheIftommFourBar) {
  const Textbook textbook(make_n_four_bar(2));
  const TextbookState end = run(textbook, 1.0, 1000);
  const Vec2 top = textbook.eval_point(end, {"post_0", "b"}).position;
  EXPECT_NEAR(top.x, -0.195020302, 1e-7);  // drift of the unprojected constraints
  EXPECT_NEAR(top.y, -0.980799206, 1e-7);
}

TEST(Textbook, TurnsTheSliderCrankAsPublished) {
  const TextbookState end = run(Textbook(make_slider_crank_torque()), 1.0, 4000);
  EXPECT_NEAR(end.bodies[1].angle, 14.127892218, 1e-6);
  EXPECT_NEAR(end.bodies[1].angle_rate, 20.537482852, 1e-6);
}

TEST(Textbook, GivesTheSliderItsAccelerationAtTheOuterDeadCentre) {
  const Mechanism ideal = make_ideal(make_slider_crank_clearance());
  const TextbookSolution solution = Textbook(ideal).solve(find_start(ideal), 0.0);
  EXPECT_NEAR(solution.accelerations[3].center.x, -19419.36, 0.01);
  EXPECT_NEAR(solution.reactions[2].force.x, -0.14 * 19419.36, 0.01);  // on the slider, at the pin
}

TEST(Textbook, StartsTheNineBarWhereTheReferenceDoes) {
  const Textbook textbook(make_nine_bar());
  const TextbookState start = find_start(textbook.mechanism());
  const auto expect_at = [&](const Anchor& anchor, Vec2 millimetres) {
    const Vec2 position = textbook.eval_point(start, anchor).position;
    EXPECT_NEAR(1e3 * position.x, millimetres.x, 1e-4) << anchor.body;
    EXPECT_NEAR(1e3 * position.y, millimetres.y, 1e-4) << anchor.body;
  };
  expect_at({"rod_2", "a"}, {22.3093, 39.0806});
  expect_at({"rod_3", "a"}, {487.3576, -75.7304});
  expect_at({"rod_2", "b"}, {187.1338, 320.3436});
  expect_at({"panel_7", "E"}, {6.5307, 499.7974});
  expect_at({"rod_8", "a"}, {252.2438, 566.4774});
  expect_at({"slider_9", "S"}, {569.8719, 460.0});
}

TEST(TextbookContact, KeepsTheMomentumOfTwoFreeBodies) {
  const Textbook textbook(make_free_pair());
  const TextbookState state = make_pressed_state(textbook.mechanism());
  const TextbookSolution solution = textbook.solve(state, 0.0);
  Vec2 force;
  double moment = 0.0;
  double torque = 0.0;
  for (std::size_t i = 1; i < state.bodies.size(); ++i) {
    const Body& body = textbook.mechanism().bodies[i];
    const Vec2 inertial = body.mass * solution.accelerations[i].center;
    force += inertial;
    torque = body.inertia * solution.accelerations[i].angle;
    moment += cross(state.bodies[i].center, inertial) + torque;
  }
  EXPECT_GT(std::abs(solution.contacts[0].friction_force), 1.0);
  EXPECT_LT(norm(force), 1e-10 * solution.contacts[0].normal_force);
  EXPECT_LT(std::abs(moment), 1e-10 * std::abs(torque));
}

TEST(TextbookContact, HasThePublishedStiffness) {
  const Textbook textbook(make_nine_bar());
  EXPECT_NEAR(textbook.eval_contacts(find_start(textbook.mechanism()))[0].stiffness, 9.664e10, 5e6);
}

TEST(TextbookContact, OpposesSlipAndActsOnlyWhenActiveAndOverlapping) {
  const Textbook textbook(make_free_body_in_bearing());
  TextbookState state = make_pressed_state(textbook.mechanism());
  const TextbookContactForce contact = textbook.eval_contacts(state)[0];
  EXPECT_NEAR(contact.penetration, 8e-6, 1e-15);
  EXPECT_LT(contact.friction_force * contact.slip_speed, 0.0);
  EXPECT_LT(dot(contact.force, contact.normal), 0.0);
  // the wheel rolls in the bearing: at 9 rad/s its surface moves at about R θ̇ along t
  EXPECT_NEAR(contact.slip_speed, 9.0 * 0.0196, 0.06);
  state.contacts[0].in_contact = false;
  EXPECT_EQ(textbook.eval_contacts(state)[0].normal_force, 0.0);
  state = find_start(textbook.mechanism());
  state.contacts[0] = {true, 0.1};
  EXPECT_EQ(textbook.eval_contacts(state)[0].normal_force, 0.0);
}

TEST(TextbookContact, TakesThePowerOfItsForces) {
  for (const Mechanism& mechanism : {make_free_pair(), make_free_body_in_bearing(), make_nine_bar()}) {
    const Textbook textbook(mechanism);
    const TextbookState state = make_pressed_state(mechanism);
    const TextbookSolution solution = textbook.solve(state, 0.0);
    double gained = 0.0;
    for (std::size_t i = 1; i < state.bodies.size(); ++i) {
      const Body& body = mechanism.bodies[i];
      const TextbookBody& motion = state.bodies[i];
      gained += body.mass * dot(motion.velocity, solution.accelerations[i].center - mechanism.gravity) +
                body.inertia * motion.angle_rate * solution.accelerations[i].angle;
    }
    double delivered = 0.0;
    double scale = 0.0;
    for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
      delivered += solution.efforts[i] * eval_motion(mechanism.drivers[i], 0.0).rate;
    }
    for (const TextbookContactForce& contact : solution.contacts) {
      delivered += contact.friction_force * contact.slip_speed - contact.normal_force * contact.penetration_rate;
      scale += contact.normal_force;
    }
    EXPECT_NEAR(gained, delivered, 1e-11 * scale) << mechanism.name;
  }
}

/// A disc that hits its bearing along a line through its centre of mass, without friction, at 0.2 m/s.
struct Impact {
  double exit_speed = 0.0;
  double deepest = 0.0;
};

Impact run_impact(AnyNormalForce law) {
  Mechanism mechanism = make_free_body_in_bearing();
  mechanism.gravity = {};
  mechanism.bodies[1].center_of_mass = mechanism.bodies[1].points[0].position;
  auto& joint = std::get<RevoluteClearance>(mechanism.joints[0].kind);
  joint.contact.friction = Frictionless{};
  joint.contact.normal_force = law;
  const Textbook textbook(mechanism);
  TextbookState state = find_start(mechanism);
  const Vec2 direction{0.28, 0.96};
  state.bodies[1].center += joint.radial_clearance * direction;
  state.bodies[1].velocity = 0.2 * direction;
  state.contacts[0] = {true, 0.2};
  Impact impact;
  TextbookContactForce contact;
  do {
    state = textbook.step_rk4(state, 0.0, 2e-8);
    contact = textbook.eval_contacts(state)[0];
    impact.deepest = std::max(impact.deepest, contact.penetration);
  } while (contact.penetration > 0.0);
  impact.exit_speed = -contact.penetration_rate;
  return impact;
}

TEST(TextbookContact, ReturnsWhatTheLawsDeliver) {
  const Mechanism mechanism = make_free_body_in_bearing();
  const double stiffness = Textbook(mechanism).eval_contacts(find_start(mechanism))[0].stiffness;
  const Impact elastic = run_impact(Hertz{1.5});
  EXPECT_NEAR(elastic.exit_speed, 0.2, 1e-6);
  EXPECT_NEAR(elastic.deepest, std::pow(2.5 * 2.0 * 0.2 * 0.2 / (2.0 * stiffness), 0.4), 1e-10);
  const Impact damped = run_impact(LankaraniNikravesh{0.9, 1.5});
  EXPECT_NEAR(damped.exit_speed / 0.2, 0.91318, 1e-5);
}

}  // namespace
}  // namespace gudgeon::oracle
