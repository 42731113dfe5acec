// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Assembly: the published start of the nine-bar, branches, guesses that are off, loops and rates that cannot be.
#include "gudgeon/system/assembly.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

using oracle::kDegree;

Vec2 find_world_point(const Mechanism& mechanism, const Assembly& assembly, const char* body, const char* point) {
  const int b = find_body(mechanism, body);
  return assembly.poses[b].find_point(find_point(mechanism.bodies[b], point)->position);
}

void expect_nine_bar_start(const Mechanism& mechanism, const Assembly& assembly) {
  const auto expect_at = [&](const char* body, const char* point, Vec2 millimetres) {
    const Vec2 found = 1e3 * find_world_point(mechanism, assembly, body, point);
    EXPECT_NEAR(found.x, millimetres.x, 1e-4) << body << "." << point;  // printed to four digits of a millimetre
    EXPECT_NEAR(found.y, millimetres.y, 1e-4) << body << "." << point;
  };
  for (const auto& [body, point] : {std::pair{"crank_1", "b"}, {"rod_2", "a"}})
    expect_at(body, point, {22.3093, 39.0806});
  for (const auto& [body, point] : {std::pair{"crank_4", "b"}, {"rod_3", "a"}})
    expect_at(body, point, {487.3576, -75.7304});
  for (const auto& [body, point] : {std::pair{"rod_2", "b"}, {"rod_3", "b"}, {"panel_7", "D"}}) {
    expect_at(body, point, {187.1338, 320.3436});
  }
  expect_at("panel_7", "E", {6.5307, 499.7974});
  expect_at("rod_8", "a", {252.2438, 566.4774});
  expect_at("slider_9", "S", {569.8719, 460.0});
}

TEST(Assembly, NineBarStartsWhereItIsPublished) {
  const Mechanism mechanism = oracle::make_nine_bar();
  const Assembly assembly = assemble(mechanism);
  expect_nine_bar_start(mechanism, assembly);
  EXPECT_LT(assembly.closure_residual, 1e-13);  // rounding of lengths of half a metre
  const double turn = 2.0 * std::numbers::pi;
  EXPECT_DOUBLE_EQ(assembly.poses[find_body(mechanism, "crank_1")].angle_rate, -turn);
  EXPECT_DOUBLE_EQ(assembly.poses[find_body(mechanism, "crank_4")].angle_rate, turn);
}

TEST(Assembly, NineBarClosesFromGuessesTwentyDegreesOff) {
  // Signs of the deviations of the six guessed bodies; the cranks and the slider have none.
  for (const unsigned signs : {0b000000u, 0b111111u, 0b010101u, 0b101010u, 0b000111u, 0b110010u}) {
    Mechanism mechanism = oracle::make_nine_bar();
    unsigned bit = 0;
    std::vector<double> off(mechanism.bodies.size(), 0.0);
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      auto& angle = mechanism.bodies[b].start.angle;
      if (!angle) continue;
      off[b] = ((signs >> bit++) & 1u) != 0u ? 20.0 * kDegree : -20.0 * kDegree;
      *angle += off[b];
    }
    const Assembly assembly = assemble(mechanism);
    expect_nine_bar_start(mechanism, assembly);
    for (std::size_t b = 1; b < off.size(); ++b) {
      EXPECT_NEAR(assembly.angle_changes[b], -off[b], 1e-6);  // guesses come from coordinates with seven digits
    }
  }
}

AnyJoint find_ideal(const AnyJoint& kind) {
  Mechanism one;
  one.joints = {{"joint", kind}};
  return make_ideal(one).joints[0].kind;
}

void expect_joints_closed(const Mechanism& mechanism, const Assembly& assembly) {
  for (const Joint& joint : mechanism.joints) {
    const AnyJoint ideal = find_ideal(joint.kind);
    if (std::holds_alternative<Prismatic>(ideal)) continue;
    const auto find_motion = [&](const Anchor& anchor) {
      const int b = find_body(mechanism, anchor.body);
      const BodyPose& pose = assembly.poses[b];
      const Vec2 position = pose.find_point(find_point(mechanism.bodies[b], anchor.point)->position);
      return std::pair{position, pose.velocity + pose.angle_rate * perp(position - pose.position)};
    };
    const auto [first, second] = anchors(joint.kind);
    const auto [first_position, first_velocity] = find_motion(first);
    const auto [second_position, second_velocity] = find_motion(second);
    // Rounding of positions below 10 m and of speeds below 100 m/s.
    if (const auto* slot = std::get_if<PinInSlot>(&ideal)) {
      const BodyPose& pose = assembly.poses[find_body(mechanism, first.body)];
      const Rotation along = make_rotation(pose.angle + slot->direction);
      const Vec2 normal{-along.s, along.c};
      const Vec2 offset = second_position - first_position;
      const Vec2 seen = second_velocity - first_velocity - pose.angle_rate * perp(offset);
      EXPECT_NEAR(dot(normal, offset), 0.0, 1e-12) << mechanism.name << "." << joint.name;
      EXPECT_NEAR(dot(normal, seen), 0.0, 1e-11) << mechanism.name << "." << joint.name;
      continue;
    }
    EXPECT_NEAR(norm(second_position - first_position), 0.0, 1e-12) << mechanism.name << "." << joint.name;
    EXPECT_NEAR(norm(second_velocity - first_velocity), 0.0, 1e-11) << mechanism.name << "." << joint.name;
  }
}

TEST(Assembly, EveryJointIsClosedInPositionAndVelocity) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    const Assembly assembly = assemble(mechanism);
    expect_joints_closed(mechanism, assembly);
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      const auto& rate = mechanism.bodies[b].start.angle_rate;
      if (!rate) continue;
      EXPECT_NEAR(assembly.poses[b].angle_rate, *rate, 1e-12 * (1.0 + std::abs(*rate))) << mechanism.name;
    }
  }
}

Mechanism make_driven_four_bar() {
  Mechanism mechanism = oracle::make_four_bar();
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 1.1, 5.3});
  return mechanism;
}

TEST(Assembly, OtherGuessesGiveTheOtherBranch) {
  Mechanism mechanism = make_driven_four_bar();
  const Assembly open = assemble(mechanism);
  // Mirror coupler and rocker on the line from the crank's pin to the right pivot.
  const Vec2 pin = find_world_point(mechanism, open, "crank", "b");
  const Vec2 right = find_point(mechanism.bodies[0], "right")->position;
  const double diagonal = std::atan2(right.y - pin.y, right.x - pin.x);
  for (const int b : {2, 3}) mechanism.bodies[b].start.angle = 2.0 * diagonal - open.poses[b].angle + 0.1;
  const Assembly crossed = assemble(mechanism);
  ASSERT_EQ(open.branches.size(), 1u);
  ASSERT_EQ(crossed.branches.size(), 1u);
  EXPECT_GT(std::abs(open.branches[0].fold), 0.1);
  EXPECT_NEAR(crossed.branches[0].fold, -open.branches[0].fold, 1e-12);  // mirror images, to rounding
  EXPECT_EQ(crossed.branches[0].joint, open.branches[0].joint);
  EXPECT_DOUBLE_EQ(crossed.poses[1].angle, 1.1);
}

TEST(Assembly, FollowsTheDriverInTime) {
  Mechanism mechanism = make_driven_four_bar();
  const Assembly later = assemble(mechanism, 0.02);
  EXPECT_DOUBLE_EQ(later.poses[1].angle, 1.1 + 5.3 * 0.02);
  // The coupler has moved as its rate says, to the second order of the time.
  const Assembly start = assemble(mechanism);
  const Assembly middle = assemble(mechanism, 0.01);
  for (const int b : {2, 3}) {
    EXPECT_NEAR(later.poses[b].angle - start.poses[b].angle, 0.02 * middle.poses[b].angle_rate, 1e-4);
    EXPECT_GT(std::abs(later.poses[b].angle - start.poses[b].angle), 1e-2);
  }
}

// Two bars of 0.1 m between pivots that are further apart than they reach.
Mechanism make_short_pair(double excess) {
  Mechanism mechanism = oracle::make_empty("short", {}, {{"left", {0.0, 0.0}}, {"right", {0.2 + excess, 0.0}}});
  mechanism.bodies.push_back(oracle::make_slender("one", 0.1, 1.0, oracle::start_at(0.3)));
  mechanism.bodies.push_back(oracle::make_slender("two", 0.1, 1.0, oracle::start_at(-0.3)));
  oracle::add_revolute(mechanism, "left", {kFrameName, "left"}, {"one", "a"});
  oracle::add_revolute(mechanism, "middle", {"one", "b"}, {"two", "a"});
  oracle::add_revolute(mechanism, "right", {"two", "b"}, {kFrameName, "right"});
  return mechanism;
}

TEST(Assembly, NamesTheJointThatCannotBeClosedAndItsGap) {
  const auto found = catch_diagnostics([] { assemble(make_short_pair(0.037)); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-070");
  EXPECT_THAT(found[0].path, testing::AnyOf("joints.middle", "joints.right"));
  EXPECT_THAT(found[0].message, testing::HasSubstr("37 mm")) << "the least gap that the bars can leave";
}

TEST(Assembly, ReportsEvenTheSmallestGap) {
  // Further apart than rounding, nearer than anyone would measure.
  for (const double excess : {1e-5, 1e-8, 1e-10}) {
    const auto found = catch_diagnostics([&] { assemble(make_short_pair(excess)); });
    ASSERT_FALSE(found.empty()) << excess;
    EXPECT_EQ(found[0].code, "E-MODEL-070");
  }
}

TEST(Assembly, ConflictingStartRatesAreErrors) {
  Mechanism mechanism = oracle::make_four_bar();  // 1 degree of freedom, and the crank has its rate
  const double consistent = assemble(mechanism).poses[3].angle_rate;
  mechanism.bodies[3].start.angle_rate = consistent;
  EXPECT_NO_THROW(assemble(mechanism));
  mechanism.bodies[3].start.angle_rate = consistent + 0.01;
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 2u);
  for (const Diagnostic& diagnostic : found) EXPECT_EQ(diagnostic.code, "E-MODEL-071");
  EXPECT_EQ(found[0].path, "bodies.crank.start.angle_rate");
  EXPECT_EQ(found[1].path, "bodies.rocker.start.angle_rate");
}

TEST(Assembly, DriversThatDisagreeAreErrors) {
  Mechanism mechanism = make_driven_four_bar();
  const Assembly assembly = assemble(mechanism);
  mechanism.bodies[3].start = {};
  mechanism.drivers.push_back({"second", DrivenAngle{"rocker"}, assembly.poses[3].angle, assembly.poses[3].angle_rate});
  EXPECT_NO_THROW(assemble(mechanism));
  mechanism.drivers.back().speed += 0.1;
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-072");
}

TEST(Assembly, LooseBodyKeepsItsStart) {
  Mechanism mechanism = oracle::make_free_pair();
  for (const bool driven : {false, true}) {
    if (driven) {
      mechanism.bodies[1].start.angle = mechanism.bodies[1].start.angle_rate = std::nullopt;
      mechanism.drivers.push_back({"motor", DrivenAngle{"housing"}, 0.3, 4.0});
    }
    const Assembly assembly = assemble(mechanism);
    expect_joints_closed(mechanism, assembly);
    const BodyPose& pose = assembly.poses[1];
    EXPECT_NEAR(norm(pose.position - Vec2{0.5, -0.3}), 0.0, 1e-15) << driven;
    EXPECT_NEAR(norm(pose.velocity - Vec2{0.2, 0.7}), 0.0, 1e-14) << driven;
    EXPECT_DOUBLE_EQ(pose.angle, 0.3);
    EXPECT_DOUBLE_EQ(pose.angle_rate, 4.0);
  }
}

}  // namespace
}  // namespace gudgeon
