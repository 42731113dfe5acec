// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Least reactions against all states of self-stress of the bodies' own equations, which know nothing of trees.
#include "gudgeon/system/self_stress.h"

#include <gtest/gtest.h>

#include "gudgeon/system/characteristic_length.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/reactions.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The wrenches that unit reactions put on all moving bodies, a column a reaction: F_x, F_y and M/ℓ as a joint has them.
struct Wrenches {
  explicit Wrenches(const Mechanism& mechanism, const std::vector<BodyMotion>& motions,
                    const std::vector<JointReaction>& reactions)
      : length(find_characteristic_length(mechanism)) {
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
      const AnyJoint& kind = mechanism.joints[j].kind;
      const auto [first, second] = anchors(kind);
      const int one = find_body(mechanism, first.body);
      const int other = find_body(mechanism, second.body);
      const BodyMotion& motion = motions[other];
      const Vec2 arm =
          find_point(mechanism.bodies[other], second.point)->position - mechanism.bodies[other].center_of_mass;
      const Vec2 at = motion.position + make_rotation(motion.angle) * arm;
      const auto add = [&](Vec2 force, double moment, double value) {
        VectorXd column = VectorXd::Zero(3 * static_cast<Index>(mechanism.bodies.size()));
        for (const auto& [body, sign] : {std::pair{other, 1.0}, std::pair{one, -1.0}}) {
          if (body == 0) continue;
          column(3 * body) += sign * force.x;
          column(3 * body + 1) += sign * force.y;
          column(3 * body + 2) += sign * (moment + cross(at - motions[body].position, force)) / length;
        }
        columns.conservativeResize(column.size(), columns.cols() + 1);
        columns.rightCols(1) = column;
        values.conservativeResize(values.size() + 1);
        values(values.size() - 1) = value;
      };
      if (const auto* slide = std::get_if<Prismatic>(&kind)) {
        const double angle = motions[one].angle + slide->direction;
        const Vec2 normal = perp(make_rotation(angle) * Vec2{1.0, 0.0});
        add(normal, 0.0, dot(reactions[j].force, normal));
      } else {
        add({1.0, 0.0}, 0.0, reactions[j].force.x);
        add({0.0, 1.0}, 0.0, reactions[j].force.y);
      }
      if (std::holds_alternative<Revolute>(kind)) continue;
      add({}, length, reactions[j].moment / length);
    }
  }

  double length;
  MatrixXd columns;
  VectorXd values;
};

// Reactions that balance all bodies are the least ones when no state of self-stress is left in them.
void expect_least(const Mechanism& mechanism, Index n_states) {
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  const State state = make_state(system, assembly);
  Workspace workspace(system.tables);
  eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), {}, {}, workspace);
  BodyMotionFinder motion(system);
  const std::vector<BodyMotion>& motions = motion.update(workspace);
  ReactionFinder finder(system);
  const Wrenches wrenches(mechanism, motions, finder.update(workspace, motions));

  const Eigen::JacobiSVD<MatrixXd> decomposition(wrenches.columns, Eigen::ComputeFullV);
  const VectorXd singular = decomposition.singularValues();
  const Index rank = (singular.array() > 1e-9 * singular(0)).count();
  const MatrixXd states = decomposition.matrixV().rightCols(wrenches.columns.cols() - rank);
  ASSERT_EQ(states.cols(), n_states) << mechanism.name;
  const double largest = wrenches.values.cwiseAbs().maxCoeff();
  ASSERT_GT(largest, 1.0);
  EXPECT_LT((states.transpose() * wrenches.values).norm(), 1e-10 * largest) << mechanism.name;

  // Balance: m (a − g) and I θ̈, but for the driver's torque.
  VectorXd missing = wrenches.columns * wrenches.values;
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const Vec2 force = mechanism.bodies[b].mass * (motions[b].acceleration - mechanism.gravity);
    missing(3 * static_cast<Index>(b)) -= force.x;
    missing(3 * static_cast<Index>(b) + 1) -= force.y;
    missing(3 * static_cast<Index>(b) + 2) -=
        mechanism.bodies[b].inertia * motions[b].angle_acceleration / wrenches.length;
  }
  for (std::size_t d = 0; d < mechanism.drivers.size(); ++d) {
    const auto& angle = std::get<DrivenAngle>(mechanism.drivers[system.topology.driven[d].driver].target);
    missing(3 * find_body(mechanism, angle.body) + 2) += workspace.effort[d] / wrenches.length;
  }
  EXPECT_LT(missing.norm(), 1e-10 * largest) << mechanism.name;
}

// Three cranks on a plate, pivots in a triangle.
Mechanism make_three_cranks() {
  const std::array<Vec2, 3> pivots{Vec2{0.0, 0.0}, Vec2{0.4, 0.15}, Vec2{0.8, 0.0}};
  Mechanism mechanism = oracle::make_empty("three_cranks", {0.0, -9.81}, {});
  mechanism.bodies.push_back({"plate", 2.0, 0.1, {0.4, 0.05}, {}, oracle::start_at(0.0)});
  for (int k = 0; k < 3; ++k) {
    const std::string crank = "crank_" + std::to_string(k);
    const std::string point = "p" + std::to_string(k);
    mechanism.bodies[0].points.push_back({point, pivots[k]});
    mechanism.bodies[1].points.push_back({point, pivots[k]});
    mechanism.bodies.push_back(oracle::make_slender(crank, 0.1, 1.0, oracle::start_at(0.7)));
    oracle::add_revolute(mechanism, "foot_" + std::to_string(k), {kFrameName, point}, {crank, "a"});
    oracle::add_revolute(mechanism, "top_" + std::to_string(k), {crank, "b"}, {"plate", point});
  }
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank_0"}, 0.7, 6.0});
  return mechanism;
}

// An arm with a plate pinned to it at several places.
Mechanism make_pinned_plate(int n_pins) {
  Mechanism mechanism = oracle::make_empty("pinned_plate", {1.0, -9.81}, {{"o", {0.0, 0.0}}});
  const std::array<Vec2, 4> pins{Vec2{0.3, 0.1}, Vec2{0.7, 0.2}, Vec2{0.4, 0.5}, Vec2{0.1, 0.3}};
  mechanism.bodies.push_back({"arm", 1.0, 0.1, {0.2, 0.0}, {{"o", {0.0, 0.0}}}, oracle::start_at(0.3)});
  mechanism.bodies.push_back({"plate", 2.0, 0.2, {0.1, 0.4}, {}, {}});
  oracle::add_revolute(mechanism, "o", {kFrameName, "o"}, {"arm", "o"});
  for (int k = 0; k < n_pins; ++k) {
    const std::string name = "p" + std::to_string(k);
    mechanism.bodies[1].points.push_back({name, pins[k]});
    mechanism.bodies[2].points.push_back({name, make_rotation(-0.4) * (pins[k] - pins[0])});
    oracle::add_revolute(mechanism, name, {"arm", name}, {"plate", name});
  }
  return mechanism;
}

// Two guides on one line carry a block with a second mass welded to it twice.
Mechanism make_block_on_two_guides() {
  Mechanism mechanism = oracle::make_empty("two_guides", {1.0, -9.81}, {{"guide", {0.1, 0.2}}});
  mechanism.bodies.push_back(
      {"block", 1.0, 0.01, {0.0, 0.05}, {{"front", {0.1, 0.0}}, {"back", {-0.1, 0.0}}, {"top", {0.0, 0.2}}}, {}});
  mechanism.bodies.push_back({"mass", 3.0, 0.02, {0.1, 0.1}, {{"low", {0.0, 0.0}}, {"high", {0.0, 0.2}}}, {}});
  mechanism.joints.push_back({"one", oracle::make_slide({kFrameName, "guide"}, {"block", "back"}, 0.3, 0.3, 0.1)});
  mechanism.joints.push_back({"two", oracle::make_slide({kFrameName, "guide"}, {"block", "front"}, 0.3, 0.3, 0.3)});
  mechanism.joints.push_back({"weld", Rigid{{"block", "top"}, {"mass", "high"}, 0.0}});
  return mechanism;
}

TEST(SelfStress, ParallelogramsShareTheirLoad) {
  Mechanism mechanism = oracle::make_parallelogram();
  expect_least(mechanism, 1);
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank_0"}, 1.2, 2.7});
  expect_least(mechanism, 1);
}

TEST(SelfStress, CranksInATriangleShareTheirLoad) { expect_least(make_three_cranks(), 1); }

TEST(SelfStress, PinsOfOneRigidBodyShareTheirLoad) {
  expect_least(make_pinned_plate(2), 1);
  expect_least(make_pinned_plate(3), 3);
  expect_least(make_pinned_plate(4), 5);
}

TEST(SelfStress, DrivenArmPassesItsEffortOn) {
  Mechanism mechanism = make_pinned_plate(3);
  mechanism.drivers.push_back({"motor", DrivenAngle{"arm"}, 0.3, 5.0});
  expect_least(mechanism, 3);
}

TEST(SelfStress, GuidesShareForcesAndMoments) { expect_least(make_block_on_two_guides(), 2); }

TEST(SelfStress, ThereIsNoneInDeterminateMechanisms) {
  for (const Mechanism& mechanism :
       {oracle::make_four_bar(), oracle::make_slider_crank(), oracle::make_n_four_bar(3)}) {
    const System system = compile(mechanism, assemble(mechanism));
    EXPECT_TRUE(SelfStress(system).empty()) << mechanism.name;
  }
}

}  // namespace
}  // namespace gudgeon
