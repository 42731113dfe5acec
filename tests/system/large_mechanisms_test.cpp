// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms of a thousand loops or joints: what took a square of their number would be felt here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "gudgeon/system/mobility.h"
#include "gudgeon/system/start_check.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

TEST(LargeMechanisms, AThousandFourBarsInARowHaveOneDegreeOfFreedom) {
  constexpr int kLoops = 1000;
  const Mechanism mechanism = oracle::make_n_four_bar(kLoops);
  const Assembly assembly = assemble(mechanism);
  require_start(mechanism, assembly);
  ASSERT_EQ(assembly.branches.size(), static_cast<std::size_t>(kLoops));
  EXPECT_LT(assembly.closure_residual, 1e-12);
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const bool is_beam = mechanism.bodies[b].name.starts_with("beam");
    ASSERT_NEAR(assembly.poses[b].angle_rate, is_beam ? 0.0 : -1.0, 1e-9) << mechanism.bodies[b].name;
  }
  const Mobility mobility = find_mobility(mechanism, assembly);
  EXPECT_EQ(mobility.n_degrees_of_freedom, 1);
  EXPECT_EQ(mobility.n_redundant_rows, 0);
  EXPECT_EQ(mobility.n_closure_rows, 2 * kLoops);
}

TEST(LargeMechanisms, EachOfFiveHundredSeparateFourBarsMovesByItself) {
  constexpr int kCopies = 500;
  const Mechanism one = oracle::make_n_four_bar(1);
  Mechanism mechanism = oracle::make_empty("separate", one.gravity, {});
  for (int k = 0; k < kCopies; ++k) {
    const std::string prefix = fmt::format("c{}_", k);
    const auto rename = [&](const Anchor& anchor) {
      return anchor.body == kFrameName ? Anchor{kFrameName, prefix + anchor.point}
                                       : Anchor{prefix + anchor.body, anchor.point};
    };
    for (const Point& point : one.bodies[0].points) {
      mechanism.bodies[0].points.push_back({prefix + point.name, point.position + Vec2{3.0 * k, 0.0}});
    }
    for (std::size_t b = 1; b < one.bodies.size(); ++b) {
      mechanism.bodies.push_back(one.bodies[b]);
      mechanism.bodies.back().name = prefix + one.bodies[b].name;
    }
    for (const Joint& joint : one.joints) {
      const auto [first, second] = anchors(joint.kind);
      oracle::add_revolute(mechanism, prefix + joint.name, rename(first), rename(second));
    }
  }
  const Mobility mobility = find_mobility(mechanism);
  EXPECT_EQ(mobility.n_degrees_of_freedom, kCopies);
  EXPECT_EQ(mobility.n_redundant_rows, 0);
  EXPECT_FALSE(mobility.singular_start);
}

TEST(LargeMechanisms, AChainOfFiveHundredClearanceJointsHangsAsGiven) {
  constexpr int kJoints = 500;
  const double down = -0.5 * std::numbers::pi;
  Mechanism mechanism = oracle::make_empty("chain", {0.0, -9.81}, {{"b", {}}});
  for (int k = 0; k < kJoints; ++k) {
    const std::string name = "bar_" + std::to_string(k);
    const std::string carrier = mechanism.bodies.back().name;
    const double tilt = 1e-3 * (k % 7);
    mechanism.bodies.push_back(oracle::make_slender(name, 1.0, 1.0, oracle::start_at(down + tilt)));
    RevoluteClearance joint;
    joint.bearing = {carrier, "b"};
    joint.journal = {name, "a"};
    joint.bearing_radius = 10e-3;
    joint.radial_clearance = 0.1e-3;
    joint.width = 10e-3;
    mechanism.joints.push_back({"j" + std::to_string(k), joint});
  }
  const Assembly assembly = assemble(mechanism);
  Vec2 end;
  for (int k = 0; k < kJoints; ++k) {
    const double angle = down + 1e-3 * (k % 7);
    const BodyPose& pose = assembly.poses[static_cast<std::size_t>(k) + 1];
    ASSERT_NEAR(pose.angle, angle, 1e-12);
    ASSERT_LT(norm(pose.position - end), 1e-9) << "journals start in the middle";
    end += Vec2{std::cos(angle), std::sin(angle)};
  }
  EXPECT_EQ(find_mobility(mechanism, assembly).n_degrees_of_freedom, 3 * kJoints);
}

}  // namespace
}  // namespace gudgeon
