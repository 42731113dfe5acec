// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms whose constraints imply each other, through whole turns: they stay closed, as one where two bodies are
// one, and their joint forces are the least.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/kinematic_cycle.h"
#include "gudgeon/sim/run_study.h"
#include "gudgeon/system/mobility.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

ModelFile read_case_file(const std::string& name) {
  ModelFile model = read_model(std::string(GUDGEON_SOURCE_DIR) + "/tests/cases/" + name + ".toml");
  EXPECT_FALSE(model.diagnostics.has_errors());
  return model;
}

const std::vector<double>& find_channel(const StageRecord& stage, const std::string& channel) {
  for (std::size_t k = 0; k < stage.channels.size(); ++k) {
    if (stage.channels[k].name == channel) return stage.values[k];
  }
  throw std::out_of_range(channel);
}

double find_peak(const StageRecord& stage, const std::string& channel) {
  double peak = 0.0;
  for (const double value : find_channel(stage, channel)) peak = std::max(peak, std::abs(value));
  return peak;
}

double find_largest_difference(const StageRecord& stage, const std::string& one, const std::string& other) {
  const auto& first = find_channel(stage, one);
  const auto& second = find_channel(stage, other);
  double largest = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    largest = std::max(largest, std::abs(std::remainder(first[i] - second[i], 2.0 * std::numbers::pi)));
  }
  return largest;
}

// From 6 x 5 Jacobians of rank 5 at 2001 angles of the crank.
const std::vector<std::pair<std::string, double>> kTrianglePeaks{{"P1", 74.95}, {"P2", 94.32}, {"P3", 72.82},
                                                                 {"G1", 80.03}, {"G2", 96.29}, {"G3", 76.05}};

TEST(RedundantConstraints, RunHasTheLeastForcesOfThreeCranks) {
  ModelFile model = read_case_file("three_cranks_in_a_triangle");
  model.study.outputs_per_cycle = 2000;
  const auto stages = run_study(model.mechanism, model.study, {});
  ASSERT_EQ(stages.size(), 1u);
  ASSERT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
  for (const auto& [joint, peak] : kTrianglePeaks) {
    EXPECT_NEAR(find_peak(stages[0], joint + ".force"), peak, 1e-3 * peak) << joint;
  }
  EXPECT_LT(stages[0].solver.closure_residual, 1e-9 * 0.8);
}

TEST(RedundantConstraints, KinematicsHasTheLeastForcesOfThreeCranks) {
  const ModelFile model = read_case_file("three_cranks_in_a_triangle");
  const KinematicRecord record = run_kinematics(model.mechanism, {1.0, 1, 2000, ""});
  ASSERT_EQ(record.motion.status, StageStatus::finished) << record.motion.message;
  for (const auto& [joint, peak] : kTrianglePeaks) {
    EXPECT_NEAR(find_peak(record.motion, joint + ".force"), peak, 1e-3 * peak) << joint;
  }
  EXPECT_THAT(record.branch_changes, IsEmpty());
}

TEST(RedundantConstraints, KinematicsFollowsThreeCranksRound) {
  const ModelFile model = read_case_file("three_cranks");
  const KinematicRecord record = run_kinematics(model.mechanism, {1.0, 2, 360, ""});
  ASSERT_EQ(record.motion.status, StageStatus::finished) << record.motion.message;
  EXPECT_LT(find_largest_difference(record.motion, "crank2.angle", "crank1.angle"), 1e-11);
  EXPECT_LT(find_largest_difference(record.motion, "crank3.angle", "crank1.angle"), 1e-11);
  EXPECT_THAT(record.dead_centres, IsEmpty());
}

TEST(RedundantConstraints, ParallelogramHasNoDeadCentres) {
  const ModelFile model = read_case_file("parallelogram_crank");
  const KinematicRecord record = run_kinematics(model.mechanism, {1.0, 1, 36, ""});
  // The change point is real.
  EXPECT_EQ(record.motion.status, StageStatus::failed);
  EXPECT_NEAR(record.failure_time, (std::numbers::pi - 0.7) / (2.0 * std::numbers::pi), 1e-6);
  EXPECT_THAT(record.dead_centres, IsEmpty());
}

TEST(RedundantConstraints, PairPinnedTwiceTurnsAsOne) {
  const ModelFile model = read_case_file("pair_pinned_twice");
  const KinematicRecord record = run_kinematics(model.mechanism, {1.0, 1, 360, ""});
  ASSERT_EQ(record.motion.status, StageStatus::finished) << record.motion.message;
  EXPECT_LT(find_largest_difference(record.motion, "a.angle", "b.angle"), 1e-14);
  const auto stages = run_study(model.mechanism, model.study, {});
  ASSERT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
  EXPECT_LT(find_largest_difference(stages[0], "a.angle", "b.angle"), 1e-14);
  // The whole weighs 2 kg with its centre at (55 mm, 35 mm): m (r ω² + g) at the top of its turn bounds the pin's
  // force.
  const double most = 2.0 * (std::hypot(0.055, 0.035) * std::pow(2.0 * std::numbers::pi, 2) + 9.81);
  EXPECT_NEAR(find_peak(stages[0], "O.force"), most, 1e-3 * most);
  EXPECT_LT(find_peak(stages[0], "P.force"), most);
}

// The coupler with the plate's mass, inertia and centre taken in.
Mechanism merge_plate(const Mechanism& mechanism) {
  Mechanism merged = mechanism;
  Body& coupler = merged.bodies[static_cast<std::size_t>(find_body(merged, "coupler"))];
  const Body& plate = mechanism.bodies[static_cast<std::size_t>(find_body(mechanism, "plate"))];
  const Vec2 centre = find_point(coupler, "P")->position + plate.center_of_mass;
  const double mass = coupler.mass + plate.mass;
  const Vec2 common = (1.0 / mass) * (coupler.mass * coupler.center_of_mass + plate.mass * centre);
  const auto find_inertia = [&](double own, double m, Vec2 at) { return own + m * dot(at - common, at - common); };
  coupler.inertia = find_inertia(coupler.inertia, coupler.mass, coupler.center_of_mass) +
                    find_inertia(plate.inertia, plate.mass, centre);
  coupler.mass = mass;
  coupler.center_of_mass = common;
  std::erase_if(merged.joints, [](const Joint& joint) { return joint.name == "P" || joint.name == "Q"; });
  std::erase_if(merged.bodies, [](const Body& body) { return body.name == "plate"; });
  return merged;
}

TEST(RedundantConstraints, PlatePinnedTwiceIsPartOfItsCoupler) {
  ModelFile model = read_case_file("plate_pinned_twice");
  // Impacts in the clearance magnify what is left of errors: both have to be exact to compare samples.
  model.study.relative_tolerance = 1e-10;
  model.study.absolute_tolerance = 1e-13;
  const auto stages = run_study(model.mechanism, model.study, {});
  const auto merged = run_study(merge_plate(model.mechanism), model.study, {});
  ASSERT_EQ(stages.size(), merged.size());
  for (std::size_t s = 0; s < stages.size(); ++s) {
    ASSERT_EQ(stages[s].status, StageStatus::finished) << stages[s].message;
    EXPECT_LT(find_largest_difference(stages[s], "coupler.angle", "plate.angle"), 1e-14) << stages[s].name;
    for (const std::string joint : {"O1", "A", "O4"}) {
      const double peak = find_peak(merged[s], joint + ".force");
      EXPECT_NEAR(find_peak(stages[s], joint + ".force"), peak, 1e-4 * peak) << stages[s].name << " " << joint;
    }
  }
}

// Each of the two lifts may move a little without the other as far as any row sees.
TEST(RedundantConstraints, SecondOrderIsTold) {
  const Mobility mobility = find_mobility(read_case_file("lift_held_to_second_order").mechanism);
  EXPECT_FALSE(mobility.singular_start);
  EXPECT_THAT(mobility.held_to_second_order, testing::AnyOf("short2", "long2", "sl2", "plat", "g2"));
  EXPECT_EQ(find_mobility(read_case_file("parallelogram_crank").mechanism).held_to_second_order, "");
}

TEST(RedundantConstraints, JointHeldToSecondOrderStaysClosedOrStopsTheRun) {
  const ModelFile model = read_case_file("lift_held_to_second_order");
  const auto stages = run_study(model.mechanism, model.study, {});
  ASSERT_EQ(stages.size(), 1u);
  EXPECT_LT(stages[0].solver.closure_residual, 1e-4);
  if (stages[0].status == StageStatus::finished) {
    EXPECT_LT(find_peak(stages[0], "plat.angle"), 1e-6);
  } else {
    EXPECT_THAT(stages[0].message, HasSubstr("E-NUM-007"));
    EXPECT_THAT(stages[0].message, HasSubstr("joint 'T2'"));
  }
}

}  // namespace
}  // namespace gudgeon
