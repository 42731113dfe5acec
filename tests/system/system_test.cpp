// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Compilation of the whole, and the round trip from assembled poses to a state and back.
#include "gudgeon/system/system.h"

#include <gtest/gtest.h>

#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/poses.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

class SystemOfMechanism : public testing::TestWithParam<Mechanism> {
 protected:
  void SetUp() override {
    update_coordinates(system.tables, 0.0, state.q.data(), state.v.data(), workspace.coordinates);
    update_closures(system.tables, workspace);
  }

  Assembly assembly = assemble(GetParam());
  System system = compile(GetParam(), assembly);
  State state = make_state(system, assembly);
  Workspace workspace{system.tables};
};

TEST_P(SystemOfMechanism, StatePutsBodiesWhereTheAssemblyHasThem) {
  const auto poses = find_poses(system.mechanism, system.topology, workspace.coordinates);
  ASSERT_EQ(poses.size(), assembly.poses.size());
  for (std::size_t b = 0; b < poses.size(); ++b) {
    const std::string& name = system.mechanism.bodies[b].name;
    const BodyPose& expected = assembly.poses[b];
    // Rounding of lengths below 10 m, of speeds below 100 m/s, and of angle rates below 1000 rad/s.
    EXPECT_NEAR(norm(poses[b].position - expected.position), 0.0, 1e-12) << name;
    EXPECT_NEAR(norm(poses[b].velocity - expected.velocity), 0.0, 1e-11) << name;
    EXPECT_NEAR(std::remainder(poses[b].angle - expected.angle, 2.0 * std::numbers::pi), 0.0, 1e-13) << name;
    EXPECT_NEAR(poses[b].angle_rate, expected.angle_rate, 1e-10) << name;
  }
}

TEST_P(SystemOfMechanism, StateClosesEveryLoop) {
  for (std::size_t c = 0; c < workspace.closure_gap.size(); ++c) {
    EXPECT_NEAR(norm(workspace.closure_gap[c]), 0.0, 1e-12);
    EXPECT_NEAR(norm(workspace.closure_rate[c]), 0.0, 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(AllMechanisms, SystemOfMechanism, testing::ValuesIn(oracle::make_all_mechanisms()),
                         [](const auto& mechanism) {
                           return mechanism.param.name + "_" + std::to_string(mechanism.index);
                         });

TEST(System, DropsRedundantRowsAndStillMeasuresThem) {
  const Mechanism mechanism = oracle::make_parallelogram();
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  EXPECT_EQ(system.tables.n_rows, 3);
  EXPECT_EQ(system.tables.n_solve, 4 + 3);
  State state = make_state(system, assembly);
  // Turn only the third crank: the gap at its top opens by its length times the angle.
  const int turn = system.topology.bodies[find_body(mechanism, "crank_2")].turn;
  state.q[turn] += 1e-3;
  Workspace workspace(system.tables);
  update_coordinates(system.tables, 0.0, state.q.data(), state.v.data(), workspace.coordinates);
  update_closures(system.tables, workspace);
  EXPECT_NEAR(norm(workspace.closure_gap[0]), 0.0, 1e-14) << "the second crank has not moved";
  EXPECT_NEAR(norm(workspace.closure_gap[1]), 0.18e-3, 1e-9);  // a chord is shorter than its arc by 1e-7 of it
  EXPECT_GT(std::abs(workspace.closure_gap[1].y), 0.05e-3);
}

TEST(System, SlidesOfLooseBodiesAreTheirCentres) {
  const Mechanism mechanism = oracle::make_free_pair();
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  const State state = make_state(system, assembly);
  ASSERT_EQ(state.q.size(), 6u);
  const Rotation turn = make_rotation(0.3);
  const Vec2 arm = turn * mechanism.bodies[1].center_of_mass;
  const Vec2 centre = Vec2{0.5, -0.3} + arm;
  const Vec2 velocity = Vec2{0.2, 0.7} + 4.0 * perp(arm);
  EXPECT_DOUBLE_EQ(state.q[0], 0.3);
  EXPECT_DOUBLE_EQ(state.v[0], 4.0);
  EXPECT_DOUBLE_EQ(state.q[2], centre.x);
  EXPECT_DOUBLE_EQ(state.q[3], centre.y);
  EXPECT_NEAR(state.v[2], velocity.x, 1e-14);
  EXPECT_NEAR(state.v[3], velocity.y, 1e-14);
}

TEST(System, SlideOfAGuideIsMeasuredAlongIt) {
  const Mechanism mechanism = oracle::make_two_slides();
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  const State state = make_state(system, assembly);
  const int lower = system.topology.counts.n_free_turns + system.topology.joint_slide[find_joint(mechanism, "lower")];
  const int upper = system.topology.counts.n_free_turns + system.topology.joint_slide[find_joint(mechanism, "upper")];
  EXPECT_NEAR(state.q[lower], 0.11, 1e-15);
  EXPECT_NEAR(state.q[upper], -0.08, 1e-15);
  EXPECT_NEAR(state.v[lower], 0.6, 1e-14);
  EXPECT_NEAR(state.v[upper], -0.45, 1e-14);
}

TEST(System, SurfacesAreReplacedOneContactAtATime) {
  const Mechanism mechanism = oracle::make_nine_bar();
  System system = compile(mechanism, assemble(mechanism));
  set_surfaces(system, 1, std::vector<double>(10, 2e-6), std::vector<double>(10, 3e-6));
  EXPECT_FALSE(is_worn(system.tables.contacts[0].surfaces));
  const auto& worn = std::get<RevoluteSurfaces>(system.tables.contacts[1].surfaces);
  EXPECT_EQ(worn.bearing_wear.least_depth(), 2e-6);
  EXPECT_EQ(worn.journal_wear.least_depth(), 3e-6);
  EXPECT_NEAR(worn.least_clearance(), 0.505e-3, 1e-16);
}

}  // namespace
}  // namespace gudgeon
