// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Poses along a smooth motion: joints of the tree stay together, velocities are derivatives.
#include "gudgeon/system/poses.h"

#include <gtest/gtest.h>

#include "tests/oracle/mechanisms.h"
#include "tests/system/smooth_motion.h"

namespace gudgeon {
namespace {

class PosesOfMechanism : public testing::TestWithParam<Mechanism> {
 protected:
  [[nodiscard]] std::vector<BodyPose> find(double t) const { return find_poses(GetParam(), topology, motion.eval(t)); }
  [[nodiscard]] Vec2 find_anchor(const std::vector<BodyPose>& poses, const Anchor& anchor) const {
    const int b = find_body(GetParam(), anchor.body);
    return poses[b].find_point(find_point(GetParam().bodies[b], anchor.point)->position);
  }

  Topology topology = find_topology(GetParam());
  SmoothMotion motion{topology.counts, 3};
};

TEST_P(PosesOfMechanism, FrameStaysWhereItIs) {
  const BodyPose frame = find(0.7)[0];
  EXPECT_EQ(frame.position, (Vec2{}));
  EXPECT_EQ(frame.velocity, (Vec2{}));
  EXPECT_EQ(frame.angle, 0.0);
  EXPECT_EQ(frame.angle_rate, 0.0);
}

TEST_P(PosesOfMechanism, JointsOfTheTreeHold) {
  const Mechanism& mechanism = GetParam();
  const Coordinates at = motion.eval(0.7);
  const std::vector<BodyPose> poses = find(0.7);
  for (std::size_t b = 1; b < poses.size(); ++b) {
    const int j = topology.bodies[b].joint;
    if (j < 0) continue;
    const auto [first, second] = anchors(mechanism.joints[j].kind);
    const Vec2 apart = find_anchor(poses, second) - find_anchor(poses, first);
    Vec2 expected;
    if (const auto* prismatic = std::get_if<Prismatic>(&mechanism.joints[j].kind)) {
      const double direction = poses[find_body(mechanism, first.body)].angle + prismatic->direction;
      expected = at.slide[topology.joint_slide[j]] * Vec2{std::cos(direction), std::sin(direction)};
      EXPECT_NEAR(poses[find_body(mechanism, second.body)].angle - poses[find_body(mechanism, first.body)].angle,
                  prismatic->relative_angle, 1e-14);
    }
    EXPECT_NEAR(norm(apart - expected), 0.0, 1e-14) << mechanism.joints[j].name;  // sums of lengths of order one
  }
}

TEST_P(PosesOfMechanism, VelocitiesAreDerivatives) {
  constexpr double kStep = 1e-5;
  for (const double t : {0.2, 1.3}) {
    const auto before = find(t - kStep);
    const auto at = find(t);
    const auto after = find(t + kStep);
    for (std::size_t b = 0; b < at.size(); ++b) {
      const Vec2 difference = (0.5 / kStep) * (after[b].position - before[b].position);
      // Third derivatives below 1e3 times the step squared; rounding is 1e-16 over the step.
      EXPECT_NEAR(norm(at[b].velocity - difference), 0.0, 1e-7) << GetParam().bodies[b].name;
      EXPECT_NEAR(at[b].angle_rate, (after[b].angle - before[b].angle) * 0.5 / kStep, 1e-7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllMechanisms, PosesOfMechanism, testing::ValuesIn(oracle::make_all_mechanisms()),
                         [](const auto& mechanism) {
                           return mechanism.param.name + "_" + std::to_string(mechanism.index);
                         });

}  // namespace
}  // namespace gudgeon
