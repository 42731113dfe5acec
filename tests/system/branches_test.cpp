// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Branches asked for are reached from either side; joints without one are told.
#include "gudgeon/system/branches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gudgeon/system/assembly.h"
#include "gudgeon/system/loop_folds.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

Mechanism drive(Mechanism mechanism, int body) {
  const double angle = *mechanism.bodies[body].start.angle;
  for (Body& one : mechanism.bodies) one.start.angle_rate.reset();
  mechanism.bodies[body].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{mechanism.bodies[body].name}, angle, 2.0});
  return mechanism;
}

/// Every loop of a mechanism reaches either side, and the closed positions are those of two different assemblies.
void expect_both_sides(Mechanism mechanism, const std::string& joint) {
  const int at = find_joint(mechanism, joint);
  ASSERT_GE(at, 0) << joint;
  for (const Branch branch : {Branch::left, Branch::right}) {
    mechanism.joints[at].branch = branch;
    const Assembly assembly = assemble(mechanism);
    EXPECT_LT(assembly.closure_residual, 1e-12);
    bool found = false;
    for (const LoopBranch& one : assembly.branches) {
      if (one.joint != joint) continue;
      found = true;
      EXPECT_GT((branch == Branch::left ? 1.0 : -1.0) * one.fold, 1e-3) << joint;
    }
    EXPECT_TRUE(found);
  }
}

TEST(Branches, BothAreReachedFromOneGuess) {
  expect_both_sides(drive(oracle::make_four_bar(), 1), "rocker_pin");
  expect_both_sides(drive(oracle::make_slider_crank(), 1), "guide");
  // Behind two loops that only close together.
  expect_both_sides(oracle::make_nine_bar(), "guide");
}

TEST(Branches, PinsInSlotsHaveThem) {
  // The slot's line turns with the rocker, beyond the pin or before it.
  Mechanism mechanism = oracle::make_quick_return();
  std::erase_if(mechanism.bodies, [](const Body& body) { return body.name == "rod" || body.name == "ram"; });
  std::erase_if(mechanism.joints, [](const Joint& joint) {
    return joint.name == "rod_pin" || joint.name == "ram_pin" || joint.name == "guide";
  });
  mechanism.loads.clear();
  expect_both_sides(mechanism, "slot");
}

TEST(Branches, ABranchThatTheOtherLoopsCannotFollowIsAnError) {
  // With the rocker hanging down, its rod does not reach the ram's guide.
  Mechanism mechanism = oracle::make_quick_return();
  const auto branches = assemble(mechanism).branches;
  const auto slot = std::ranges::find(branches, "slot", &LoopBranch::joint);
  ASSERT_NE(slot, branches.end());
  mechanism.joints[find_joint(mechanism, "slot")].branch = slot->fold > 0.0 ? Branch::right : Branch::left;
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-077");
  EXPECT_EQ(found[0].path, "joints.slot.branch");
}

TEST(Branches, LoopsBehindDriversBetweenBodiesHaveThem) {
  // Crank and first rod are known, the rod by its angle against the crank: the other two links are a dyad.
  Mechanism mechanism = drive(oracle::make_five_bar(), 1);
  mechanism.bodies[2].start = {};
  mechanism.drivers.push_back({"elbow", DrivenAngle{"rod_2", "crank_1"}, -1.0, 0.5});
  const std::string joint = assemble(mechanism).branches.front().joint;
  expect_both_sides(mechanism, joint);
  const Mechanism ideal = make_ideal(mechanism);
  const Topology topology = find_topology(ideal);
  const Tables tables = compile_tables(ideal, topology);
  const LoopFolds folds(topology, tables);
  ASSERT_EQ(folds.folds().size(), 1u) << "a driver's closure folds nowhere";
  EXPECT_TRUE(folds.folds()[0].is_dyad);
}

TEST(Branches, ALoopWhoseDriverSharesItsUnknownsIsNoDyad) {
  Mechanism mechanism = oracle::make_four_bar();
  for (Body& body : mechanism.bodies) body.start.angle_rate.reset();
  mechanism.drivers.push_back({"elbow", DrivenAngle{"coupler", "crank"}, 0.56 - 1.1, 0.5});
  const Topology topology = find_topology(mechanism);
  const Tables tables = compile_tables(mechanism, topology);
  const LoopFolds folds(topology, tables);
  ASSERT_EQ(folds.folds().size(), 1u);
  EXPECT_FALSE(folds.folds()[0].is_dyad);
  EXPECT_EQ(assemble(mechanism).branches.size(), 1u);
}

TEST(Branches, UndrivenLoopFoldsWhereItCloses) {
  Mechanism mechanism = oracle::make_four_bar();
  for (Body& body : mechanism.bodies) body.start.angle_rate.reset();
  expect_both_sides(mechanism, assemble(mechanism).branches.front().joint);
}

TEST(Branches, SliderCrankMirrorsItsRodOnTheGuide) {
  Mechanism mechanism = drive(oracle::make_slider_crank(), 1);
  mechanism.bodies[1].start = {};
  const int guide = find_joint(mechanism, "guide");
  mechanism.joints[guide].branch = Branch::left;
  const Assembly left = assemble(mechanism);
  mechanism.joints[guide].branch = Branch::right;
  const Assembly right = assemble(mechanism);
  // Mirror images on the guide's normal, which stands at 0.2 rad + 90°.
  EXPECT_NEAR(
      std::remainder(left.poses[2].angle + right.poses[2].angle - 2.0 * 0.2 - std::numbers::pi, 2.0 * std::numbers::pi),
      0.0, 1e-12);
}

TEST(Branches, OnlyJointsThatCloseLoopsHaveThem) {
  Mechanism mechanism = drive(oracle::make_four_bar(), 1);
  mechanism.joints[find_joint(mechanism, "left")].branch = Branch::left;
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-078");
  EXPECT_EQ(found[0].path, "joints.left.branch");
  EXPECT_THAT(found[0].notes[0], testing::HasSubstr(assemble(drive(oracle::make_four_bar(), 1)).branches[0].joint));
}

TEST(Branches, ABranchThatDoesNotExistIsAnError) {
  // Coupler and rocker stretched out: the two branches meet, neither side is left or right.
  Mechanism mechanism = oracle::make_empty("flat", {}, {{"left", {0.0, 0.0}}, {"right", {2.0, 0.0}}});
  mechanism.bodies.push_back(oracle::make_slender("one", 1.0, 1.0, oracle::start_at(0.0)));
  mechanism.bodies.push_back(oracle::make_slender("two", 1.0, 1.0, oracle::start_at(0.0)));
  oracle::add_revolute(mechanism, "left", {kFrameName, "left"}, {"one", "a"});
  oracle::add_revolute(mechanism, "right", {kFrameName, "right"}, {"two", "b"});
  oracle::add_revolute(mechanism, "middle", {"one", "b"}, {"two", "a"});
  mechanism.joints[2].branch = Branch::left;
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-077");
}

}  // namespace
}  // namespace gudgeon
