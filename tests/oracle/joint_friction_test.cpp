// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Friction in ideal joints against the textbook form: what the engine finds acts there as loads that are given; the
// same accelerations, efforts and reactions must come out, and the reactions must make that friction by the laws,
// written out here once more.
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/system/reactions.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/same_state.h"
#include "tests/oracle/textbook.h"

namespace gudgeon::oracle {
namespace {

constexpr double kRadius = 0.012;
constexpr double kHeight = 0.03;
const CoulombSmooth kLaw{0.3, 0.05};

// Short enough to tilt, and not so short as to jam.
double find_length(const Mechanism& mechanism) {
  return mechanism.name == "two_slides" || mechanism.name == "loaded_slides" ? 0.3 : 0.05;
}

Mechanism add_friction(Mechanism mechanism) {
  const double length = find_length(mechanism);
  for (Joint& joint : mechanism.joints) {
    if (auto* pin = std::get_if<Revolute>(&joint.kind)) pin->friction = JointFriction{kLaw, kRadius, 0.0, 0.0};
    if (auto* slot = std::get_if<PinInSlot>(&joint.kind)) slot->friction = JointFriction{kLaw, kRadius, 0.0, 0.0};
    if (auto* guide = std::get_if<Prismatic>(&joint.kind)) guide->friction = JointFriction{kLaw, 0.0, length, kHeight};
  }
  return mechanism;
}

// The same without friction, pushed by the forces that friction was found to be.
Mechanism load_with(Mechanism mechanism, const EngineAt& engine, const TextbookState& state) {
  const Textbook textbook(mechanism);
  for (const FrictionJoint& at : engine.system.tables.friction_joints) {
    const FrictionPair& pair =
        engine.equations.workspace.friction_forces[&at - engine.system.tables.friction_joints.data()].pair;
    const auto [first, second] = anchors(mechanism.joints[at.joint].kind);
    const int first_body = find_body(mechanism, first.body);
    const Vec2 place = textbook.eval_point(state, second).position;
    const TextbookBody& carrier = state.bodies[first_body];
    const Rotation back = make_rotation(-carrier.angle);
    const Vec2 local =
        (first_body == 0 ? Vec2{} : mechanism.bodies[first_body].center_of_mass) + back * (place - carrier.center);
    const std::string name = "friction_" + std::to_string(at.joint);
    mechanism.bodies[first_body].points.push_back({name, local});
    const std::string first_name = first.body;
    if (second.body != kFrameName) {
      mechanism.loads.push_back({name + "a", ConstantForce{second, pair.force}});
      mechanism.loads.push_back({name + "b", ConstantTorque{second.body, pair.torque}});
    }
    if (first_name != kFrameName) {
      mechanism.loads.push_back({name + "c", ConstantForce{{first_name, name}, -pair.force}});
      mechanism.loads.push_back({name + "d", ConstantTorque{first_name, -pair.torque}});
    }
  }
  return mechanism;
}

// Friction by the laws from a reaction without friction, at the motion of the two bodies.
FrictionPair find_friction_of(const Textbook& textbook, const TextbookState& state, const Joint& joint,
                              const TextbookReaction& reaction) {
  const auto [first, second] = anchors(joint.kind);
  const TextbookBody& one = state.bodies[find_body(textbook.mechanism(), first.body)];
  const TextbookBody& two = state.bodies[find_body(textbook.mechanism(), second.body)];
  const double turning = two.angle_rate - one.angle_rate;
  const auto coefficient = [](double v) { return 0.3 * std::tanh(v / 0.05); };
  if (std::holds_alternative<Revolute>(joint.kind)) {
    const double angle = std::atan(coefficient(kRadius * turning));
    return {{}, -kRadius * std::sin(angle) * norm(reaction.force)};
  }
  const auto* guide = std::get_if<Prismatic>(&joint.kind);
  const double direction = guide != nullptr ? guide->direction : std::get<PinInSlot>(joint.kind).direction;
  const Rotation line = make_rotation(one.angle + direction);
  const Vec2 along{line.c, line.s};
  const TextbookPoint at = textbook.eval_point(state, second);
  const Vec2 carried = one.velocity + one.angle_rate * perp(at.position - one.center);
  const Vec2 across = perp(along);
  const double normal = dot(reaction.force, across);
  if (guide == nullptr) {
    // The wall that pushes to the left is on the right.
    const Vec2 touch = at.position - (normal < 0.0 ? -1.0 : 1.0) * kRadius * across;
    const Vec2 on_pin = at.velocity + two.angle_rate * perp(touch - at.position);
    const Vec2 on_wall = one.velocity + one.angle_rate * perp(touch - one.center);
    const double slip = dot(on_pin - on_wall, along);
    const Vec2 force = -coefficient(slip) * std::abs(normal) * along;
    return {force, cross(touch - at.position, force)};
  }
  // Ends ±L/2, on the side that each touches: N1 + N2 = N; N1, N2 and their frictions have the moment M.
  const double length = find_length(textbook.mechanism());
  const double mu = coefficient(dot(at.velocity - carried, along));
  for (const double side_1 : {1.0, -1.0}) {
    for (const double side_2 : {1.0, -1.0}) {
      // friction −μ|N| along at −side h/2 across has the moment −side h/2 μ |N| = −h/2 μ N
      const double lever = -0.5 * kHeight * mu;
      // N1 (L/2 + lever) + (N − N1)(−L/2 + lever) = M
      const double n_1 = (reaction.moment - normal * (lever - 0.5 * length)) / length;
      const double n_2 = normal - n_1;
      if (n_1 * side_1 >= 0.0 && n_2 * side_2 >= 0.0) return {-mu * (n_1 * side_1 + n_2 * side_2) * along, 0.0};
    }
  }
  return {};
}

class JointFrictionIn : public testing::TestWithParam<int> {};

std::vector<Mechanism> list_mechanisms() {
  Mechanism turned = make_slider_crank();
  auto& pin = std::get<Revolute>(turned.joints[1].kind);
  std::swap(pin.first, pin.second);
  return {make_pendulum_chain(3),
          make_rigid_chain(),
          make_slider_crank(),
          turned,
          make_four_bar(),
          make_five_bar(),
          make_six_bar_slide(),
          make_two_slides(),
          make_driven_slide(),
          make_swung_slider_crank(),
          make_driven_arm(false),
          make_driven_arm(true),
          make_scotch_yoke(),
          make_quick_return(),
          make_trammel(),
          make_moved_slides(),
          make_splined_slide(),
          make_loaded_driven_slide(),
          make_loaded_slides(),
          make_sprung_four_bar(),
          make_slider_crank_guide(),
          make_scotch_yoke_clearance(),
          make_loaded_clearance()};
}

TEST_P(JointFrictionIn, IsWhatTheReactionsMakeInTheTextbookForm) {
  const Mechanism plain = list_mechanisms()[GetParam()];
  const Mechanism mechanism = add_friction(plain);
  const bool touches = std::ranges::any_of(mechanism.joints, [](const Joint& j) { return has_clearance(j.kind); });
  EngineAt engine(mechanism, touches ? make_pressed_start(mechanism) : make_free_start(mechanism));
  engine.equations.eval(0.0, engine.y.data(), engine.slope.data());
  const Workspace& workspace = engine.equations.workspace;
  ASSERT_GT(workspace.friction_margin, 0.5);
  BodyMotionFinder finder(engine.system);
  const std::vector<BodyMotion> motions = finder.update(workspace);
  TextbookState state;
  for (const BodyMotion& at : motions) state.bodies.push_back({at.position, at.angle, at.velocity, at.angle_rate});
  for (const ContactMode& mode : engine.equations.contact_modes) {
    state.contacts.push_back({mode.in_contact, mode.onset_speed});
  }
  const Textbook textbook(load_with(plain, engine, state));
  const TextbookSolution solution = textbook.solve(state, 0.0);
  double largest = 0.0;
  for (const TextbookAcceleration& body : solution.accelerations) largest = std::max(largest, norm(body.center));
  for (std::size_t b = 1; b < motions.size(); ++b) {
    EXPECT_LT(norm(motions[b].acceleration - solution.accelerations[b].center), 1e-9 * largest) << b;
  }
  for (std::size_t d = 0; d < plain.drivers.size(); ++d) {
    const auto found = std::ranges::find(engine.system.tables.driven, static_cast<int>(d), &DrivenMotion::driver);
    EXPECT_NEAR(workspace.effort[found - engine.system.tables.driven.begin()], solution.efforts[d],
                1e-9 * (1.0 + std::abs(solution.efforts[d])));
  }
  ReactionFinder reactions(engine.system);
  reactions.update(workspace, motions);
  double rubbing = 0.0;
  for (std::size_t k = 0; k < workspace.friction_forces.size(); ++k) {
    const int j = engine.system.tables.friction_joints[k].joint;
    const FrictionPair& pair = workspace.friction_forces[k].pair;
    const FrictionPair expected = find_friction_of(textbook, state, plain.joints[j], solution.reactions[j]);
    const double size = 1.0 + norm(solution.reactions[j].force);
    EXPECT_LT(norm(pair.force - expected.force), 1e-9 * size) << plain.joints[j].name;
    EXPECT_NEAR(pair.torque, expected.torque, 1e-9 * size) << plain.joints[j].name;
    EXPECT_LT(norm(reactions.reactions()[j].force - solution.reactions[j].force - pair.force), 1e-9 * size);
    EXPECT_NEAR(reactions.reactions()[j].moment, solution.reactions[j].moment + pair.torque, 1e-9 * size);
    EXPECT_GE(workspace.friction_forces[k].power, 0.0);
    rubbing += workspace.friction_forces[k].power;
  }
  EXPECT_GT(rubbing, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Mechanisms, JointFrictionIn, testing::Range(0, 23), [](const auto& at) {
  return std::to_string(at.param) + "_" + list_mechanisms()[at.param].name;
});

}  // namespace
}  // namespace gudgeon::oracle
