// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Starts of model files: rates that are had exactly, guesses that choose a branch, play that closes a loop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/system/assembly.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/start_check.h"
#include "gudgeon/system/start_remarks.h"
#include "gudgeon/system/system.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;

ModelFile read_case_file(const std::string& name, const std::vector<Override>& overrides = {}) {
  ModelFile model = read_model(std::string(GUDGEON_SOURCE_DIR) + "/tests/cases/" + name + ".toml", {}, overrides);
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  return model;
}

const BodyPose& find_pose(const Mechanism& mechanism, const Assembly& assembly, const char* body) {
  return assembly.poses[find_body(mechanism, body)];
}

std::vector<Diagnostic> list_remarks(const Mechanism& mechanism) {
  const Diagnostics found = remark_start(mechanism, assemble(mechanism));
  return {found.items().begin(), found.items().end()};
}

TEST(StartCases, TheSpeedOfAGuideInALoopTurnsTheCrank) {
  const Mechanism mechanism = read_case_file("guide_start_speed").mechanism;
  const Assembly assembly = assemble(mechanism);
  // x = r cos θ + √(l² − r² sin² θ) of a slider-crank, at ẋ = −0.3 m/s.
  const double r = 0.05;
  const double l = 0.12;
  const double s = std::sin(1.0);
  const double reach = std::sqrt(l * l - r * r * s * s);
  const double rate = 0.3 / (r * s * (1.0 + r * std::cos(1.0) / reach));
  EXPECT_NEAR(rate, 5.7485, 5e-5);
  EXPECT_NEAR(find_pose(mechanism, assembly, "crank").angle_rate, rate, 1e-12);
  EXPECT_NEAR(find_pose(mechanism, assembly, "slider").velocity.x, -0.3, 1e-14);
  EXPECT_EQ(find_pose(mechanism, assembly, "crank").angle, 1.0) << "free, so taken exactly";
}

TEST(StartCases, TwoRatesOnOneDegreeOfFreedomMustAgree) {
  Mechanism mechanism = read_case_file("guide_start_speed").mechanism;
  mechanism.bodies[1].start.angle_rate = 5.0;
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].code, "E-MODEL-071");
  EXPECT_EQ(found[0].path, "bodies.crank.start.angle_rate");
  EXPECT_EQ(found[1].path, "joints.guide.start.speed");
}

TEST(StartCases, TheVelocityOfABodyOnAGuideIsHad) {
  Mechanism mechanism = read_case_file("body_start_velocity").mechanism;
  const Assembly assembly = assemble(mechanism);
  EXPECT_DOUBLE_EQ(find_pose(mechanism, assembly, "bar").velocity.y, 1.0);
  EXPECT_NEAR(find_pose(mechanism, assembly, "bar").velocity.x, 0.0, 1e-16);
  mechanism.bodies[1].start.velocity = Vec2{0.5, 1.0};
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 1U) << "the guide permits no velocity across it";
  EXPECT_EQ(found[0].code, "E-MODEL-071");
  EXPECT_EQ(found[0].path, "bodies.bar.start.velocity");
}

TEST(StartCases, ADrivenGuideTellsWhatItDoesNotTake) {
  const ModelFile model = read_case_file("slide_start_contradiction");
  std::vector<Diagnostic> found(model.diagnostics.items().begin(), model.diagnostics.items().end());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "R-MODEL-107");
  EXPECT_EQ(found[0].path, "drivers.d.motion");
  EXPECT_THAT(found[0].message, HasSubstr("starts at 0 mm, joint 'G' at 200 mm; the driver's holds"));
  found = list_remarks(model.mechanism);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "R-MODEL-107");
  EXPECT_EQ(found[0].path, "joints.G.start.speed");
  EXPECT_THAT(found[0].message, HasSubstr("is 3 m/s, driver 'd' starts with 0.0628319 m/s; the driver's holds"));
}

TEST(StartCases, AJournalMayMoveWithinItsPlay) {
  const Mechanism mechanism = read_case_file("start_in_the_play").mechanism;
  const Assembly assembly = assemble(mechanism);
  EXPECT_DOUBLE_EQ(find_pose(mechanism, assembly, "ball").velocity.x, 0.018);
  EXPECT_NEAR(find_pose(mechanism, assembly, "walls").velocity.x, 0.01, 1e-12) << "a motion's rate by differences";
  EXPECT_NO_THROW(require_start(mechanism, assembly));
  EXPECT_FALSE(assemble_ideal(mechanism)) << "without play both move alike";
}

TEST(StartCases, AGuideThatClearanceLeavesFreeStartsOffTheMiddle) {
  const Mechanism mechanism =
      read_case_file("start_in_the_play", {{"joints.guide.start.displacement", "0.5 mm"}}).mechanism;
  const Assembly assembly = assemble(mechanism);
  EXPECT_DOUBLE_EQ(find_pose(mechanism, assembly, "ball").position.x, 0.5e-3);
  EXPECT_NO_THROW(require_start(mechanism, assembly));
  const auto found = list_remarks(mechanism);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "R-MODEL-112");
  EXPECT_THAT(found[0].message, HasSubstr("'slot': its journal starts 0.5 mm off the middle"));
}

TEST(StartCases, AHolePitchThatIsOffClosesThanksToClearance) {
  const ModelFile model = read_case_file("pitch_error_within_clearance");
  const Mechanism& mechanism = model.mechanism;
  const Assembly assembly = assemble(mechanism);
  const auto find_place = [&](const char* body, const char* point) {
    const int b = find_body(mechanism, body);
    return assembly.poses[b].find_point(find_point(mechanism.bodies[b], point)->position);
  };
  for (const Joint& joint : mechanism.joints) {
    const auto [first, second] = anchors(joint.kind);
    const double apart = norm(find_place(first.body.c_str(), first.point.c_str()) -
                              find_place(second.body.c_str(), second.point.c_str()));
    // The middle crank stands at the angle given for it, as the outer two do.
    EXPECT_NEAR(apart, has_clearance(joint.kind) ? 0.05e-3 : 0.0, 1e-12) << joint.name;
  }
  EXPECT_NO_THROW(require_start(mechanism, assembly));
  const Diagnostics ideal = remark_ideal_start(mechanism, model.study);
  ASSERT_EQ(ideal.items().size(), 1U);
  EXPECT_EQ(ideal.items()[0].code, "R-MODEL-113");
}

TEST(StartCases, APinLiesAsLittleOffCentreAsItCan) {
  Mechanism mechanism = read_case_file("pitch_error_within_clearance").mechanism;
  mechanism.bodies[find_body(mechanism, "c2")].start.angle.reset();
  const Assembly assembly = assemble(mechanism);
  const int rod = find_body(mechanism, "rod");
  const int crank = find_body(mechanism, "c2");
  const Vec2 hole = assembly.poses[rod].find_point({0.40005, 0.0});
  const Vec2 pin = assembly.poses[crank].find_point({0.1, 0.0});
  // The crank points at the hole, which is that much further from the pivot than the crank is long.
  const double off = std::hypot(0.1 * std::cos(0.7) + 5e-5, 0.1 * std::sin(0.7)) - 0.1;
  EXPECT_NEAR(norm(hole - pin), off, 1e-12);
}

TEST(StartCases, AMisfitBeyondTheClearanceIsToldAsBefore) {
  const ModelFile model = read_case_file("pitch_error_within_clearance", {{"joints.P2.radial_clearance", "0.03 mm"}});
  const auto found = catch_diagnostics([&] { assemble(model.mechanism); });
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].code, "E-MODEL-070");
}

TEST(StartCases, AGroupOfClassThreeHasAllItsAssemblies) {
  Mechanism mechanism = read_case_file("class3_branch").mechanism;
  const auto all = find_all_assemblies(mechanism);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 2U) << "what 3000 starts of a root finder met";
  const Assembly start = assemble(mechanism);
  const int link = find_body(mechanism, "tern");
  EXPECT_NEAR(start.poses[link].angle, 0.5768574068568086, 1e-9);
  mechanism.joints[find_joint(mechanism, "P3")].branch = Branch::right;
  const Assembly other = assemble(mechanism);
  EXPECT_NEAR(1e3 * other.poses[link].position.x, 54.497, 5e-4);
  EXPECT_NEAR(1e3 * other.poses[link].position.y, 174.098, 5e-4);
  EXPECT_NEAR(std::remainder(other.poses[link].angle, 2.0 * std::numbers::pi) / oracle::kDegree, -40.728, 5e-4);
  EXPECT_LT(other.closure_residual, 1e-12);
}

TEST(StartCases, ABranchThatNoAssemblyHasIsAnError) {
  Mechanism mechanism = read_case_file("class3_branch").mechanism;
  const auto all = find_all_assemblies(mechanism);
  ASSERT_TRUE(all);
  // All four pairs of sides are asked for; those that no assembly has are errors, and no others.
  const auto& names = all->front().branches;
  ASSERT_EQ(names.size(), 2U);
  for (const bool first : {false, true}) {
    for (const bool second : {false, true}) {
      const bool exists = std::ranges::any_of(*all, [&](const Assembly& one) {
        return (one.branches[0].fold > 0.0) == first && (one.branches[1].fold > 0.0) == second;
      });
      mechanism.joints[find_joint(mechanism, names[0].joint)].branch = first ? Branch::left : Branch::right;
      mechanism.joints[find_joint(mechanism, names[1].joint)].branch = second ? Branch::left : Branch::right;
      if (exists) {
        EXPECT_NO_THROW(assemble(mechanism));
      } else {
        EXPECT_EQ(catch_diagnostics([&] { assemble(mechanism); }).front().code, "E-MODEL-077");
      }
    }
  }
}

TEST(StartCases, ASingularStartIsRefused) {
  const Mechanism mechanism = read_case_file("singular_start").mechanism;
  const auto found = catch_diagnostics([&] { require_start(mechanism, assemble(mechanism)); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E-MODEL-073");
}

TEST(StartCases, ABlockMayPressAsFarAsItsLoadPressesIt) {
  const auto start_at = [](const char* depth) {
    const Mechanism mechanism =
        read_case_file("rests_exactly_on_surface", {{"bodies.block.start.position.1", depth}}).mechanism;
    require_start(mechanism, assemble(mechanism));
  };
  EXPECT_NO_THROW(start_at("-0.05 mm"));
  EXPECT_NO_THROW(start_at("-0.0500001 mm")) << "it would sink deeper";
  EXPECT_EQ(catch_diagnostics([&] { start_at("-0.06 mm"); }).front().code, "E-MODEL-074");
}

TEST(StartCases, APointMassOnAPinSwingsWithItsBar) {
  Mechanism mechanism = read_case_file("point_mass_on_pin").mechanism;
  const Assembly assembly = assemble(mechanism);
  EXPECT_NO_THROW(require_start(mechanism, assembly));
  const System system = compile(mechanism, assembly);
  Workspace workspace(system.tables);
  const State state = make_state(system, assembly);
  eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), {}, {}, workspace);
  // I θ̈ = −g (m₁ c + m₂ L) with the bar level.
  const double inertia = 0.01 + 1.0 * 0.1 * 0.1 + 2.0 * 0.2 * 0.2;
  EXPECT_NEAR(workspace.equations[system.topology.bodies[1].turn], -9.81 * (1.0 * 0.1 + 2.0 * 0.2) / inertia, 1e-12);
  EXPECT_EQ(workspace.equations[system.topology.bodies[2].turn], 0.0);
  // A torque on what has no inertia has no answer.
  mechanism.loads.push_back({"twist", ConstantTorque{"payload", 1.0}});
  const auto found = catch_diagnostics([&] { require_start(mechanism, assemble(mechanism)); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E-MODEL-076");
  EXPECT_EQ(found[0].path, "bodies.payload.inertia");
}

TEST(StartCases, ADisplacementChoosesTheBranchOfItsLoop) {
  // The rod points ahead of the crank's pin, or back: the guide's displacement says which, whatever the rod's angle.
  Mechanism mechanism = read_case_file("guide_start_speed").mechanism;
  auto& guide = std::get<Prismatic>(mechanism.joints[find_joint(mechanism, "guide")].kind);
  guide.start.speed.reset();
  mechanism.bodies[2].start = {};
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 1.0, 0.0});
  const double half = std::sqrt(0.12 * 0.12 - 0.05 * 0.05 * std::sin(1.0) * std::sin(1.0));
  for (const double sign : {1.0, -1.0}) {
    const double exact = 0.05 * std::cos(1.0) + sign * half;
    guide.start.displacement = exact + 3e-3;
    const Assembly assembly = assemble(mechanism);
    EXPECT_NEAR(find_pose(mechanism, assembly, "slider").position.x, exact, 1e-12);
    const auto found = list_remarks(mechanism);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].code, "R-MODEL-111");
    EXPECT_EQ(found[0].path, "joints.guide.start.displacement");
    EXPECT_THAT(found[0].message, HasSubstr("starts 3 mm from there"));
  }
}

TEST(StartCases, WhatTheLoopsLeaveFreeIsTakenExactly) {
  // One degree of freedom: the first angle given is exact, the others are guesses.
  Mechanism mechanism = oracle::make_four_bar();
  for (Body& body : mechanism.bodies) body.start.angle_rate.reset();
  const Assembly exact = assemble(mechanism);
  for (std::size_t b = 2; b < mechanism.bodies.size(); ++b)
    mechanism.bodies[b].start.angle = exact.poses[b].angle + 0.1;
  const Assembly assembly = assemble(mechanism);
  EXPECT_EQ(assembly.poses[1].angle, *mechanism.bodies[1].start.angle);
  for (const int b : {2, 3}) EXPECT_NEAR(assembly.poses[b].angle, exact.poses[b].angle, 1e-12);
  const auto found = list_remarks(mechanism);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "R-MODEL-111");
  EXPECT_THAT(found[0].message, HasSubstr("starts 5.73 deg from there"));
}

TEST(StartCases, AGuideInALoopCanBeTheOneThatIsExact) {
  Mechanism mechanism = read_case_file("guide_start_speed").mechanism;
  for (const int b : {1, 2}) mechanism.bodies[b].start = {};
  auto& guide = std::get<Prismatic>(mechanism.joints[find_joint(mechanism, "guide")].kind);
  guide.start.speed.reset();
  guide.start.displacement = 0.13;
  const Assembly assembly = assemble(mechanism);
  EXPECT_NEAR(find_pose(mechanism, assembly, "slider").position.x, 0.13, 1e-14);
  EXPECT_TRUE(list_remarks(mechanism).empty());
}

TEST(StartCases, TwoDriversOnOneDegreeOfFreedomAreNamed) {
  Mechanism mechanism = oracle::make_four_bar();
  const Assembly assembly = assemble(mechanism);
  for (Body& body : mechanism.bodies) body.start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, assembly.poses[1].angle, 0.0});
  mechanism.drivers.push_back({"second", DrivenAngle{"rocker"}, assembly.poses[3].angle + 0.3, 0.0});
  const auto found = catch_diagnostics([&] { assemble(mechanism); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E-MODEL-045");
  EXPECT_THAT(found[0].message, HasSubstr("2 drivers (motor, second) on 1 degree of freedom"));
}

}  // namespace
}  // namespace gudgeon
