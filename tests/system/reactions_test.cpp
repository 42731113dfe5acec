// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reactions by hand: supports of a beam, a cantilever, a block on a driven guide, a whirling crank; and drivers in
// places where no other mechanism has them, against the textbook form.
#include "gudgeon/system/reactions.h"

#include <gtest/gtest.h>

#include "gudgeon/system/dynamics.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook.h"

namespace gudgeon {
namespace {

using oracle::make_bar;
using oracle::make_empty;

// Forces of tens of newtons from sums of a few products.
constexpr double kReactionTolerance = 1e-12;
constexpr double kGravity = 9.81;

// A mechanism evaluated at its start, all contacts open.
struct Started {
  explicit Started(const Mechanism& mechanism)
      : assembly(assemble(mechanism)), system(compile(mechanism, assembly)), workspace(system.tables), finder(system) {
    const State state = make_state(system, assembly);
    const std::vector<ContactMode> contact_modes(system.tables.contacts.size());
    eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), contact_modes, {}, workspace);
    motions = BodyMotionFinder(system).update(workspace);
    finder.update(workspace, motions);
  }
  const JointReaction& reaction(const char* joint) const {
    return finder.reactions()[find_joint(system.mechanism, joint)];
  }

  Assembly assembly;
  System system;
  Workspace workspace;
  ReactionFinder finder;
  std::vector<BodyMotion> motions;
};

void expect_force(const JointReaction& reaction, Vec2 expected) {
  EXPECT_NEAR(reaction.force.x, expected.x, kReactionTolerance);
  EXPECT_NEAR(reaction.force.y, expected.y, kReactionTolerance);
}

TEST(Reactions, BeamOnAPinAndAHanger) {
  // Beam of 2 m and 3 kg with its centre of mass at 0.7 m; a rod of 1 kg straight up from its right end.
  Mechanism mechanism = make_empty("beam", {0.0, -kGravity}, {{"left", {0.0, 0.0}}, {"top", {2.0, 0.5}}});
  mechanism.bodies.push_back(make_bar("beam", 2.0, 3.0, 1.0, {0.7, 0.0}, oracle::start_at(0.0)));
  mechanism.bodies.push_back(make_bar("rod", 0.5, 1.0, 0.02, {0.2, 0.0}, oracle::start_at(0.5 * std::numbers::pi)));
  oracle::add_revolute(mechanism, "left", {kFrameName, "left"}, {"beam", "a"});
  oracle::add_revolute(mechanism, "right", {"rod", "a"}, {"beam", "b"});
  oracle::add_revolute(mechanism, "top", {"rod", "b"}, {kFrameName, "top"});  // the frame is second
  const Started started(mechanism);
  const double weight = 3.0 * kGravity;
  expect_force(started.reaction("left"), {0.0, 0.65 * weight});
  expect_force(started.reaction("right"), {0.0, 0.35 * weight});
  expect_force(started.reaction("top"), {0.0, -0.35 * weight - kGravity});
  for (const char* joint : {"left", "right", "top"}) EXPECT_EQ(started.reaction(joint).moment, 0.0);
}

TEST(Reactions, CantileverHoldsWeightLoadAndTorque) {
  for (const bool frame_first : {true, false}) {
    Mechanism mechanism = make_empty("cantilever", {0.0, -kGravity}, {{"wall", {0.3, 0.1}}});
    mechanism.bodies.push_back(make_bar("bar", 2.0, 3.0, 1.0, {0.7, 0.0}, {}));
    const Anchor wall{kFrameName, "wall"};
    const Anchor foot{"bar", "a"};
    mechanism.joints.push_back({"weld", frame_first ? Rigid{wall, foot, 0.0} : Rigid{foot, wall, 0.0}});
    mechanism.loads.push_back({"push", ConstantForce{{"bar", "b"}, {5.0, -7.0}}});
    mechanism.loads.push_back({"twist", ConstantTorque{"bar", 4.0}});
    const Started started(mechanism);
    const double sign = frame_first ? 1.0 : -1.0;  // on the second body
    expect_force(started.reaction("weld"), sign * Vec2{-5.0, 3.0 * kGravity + 7.0});
    EXPECT_NEAR(started.reaction("weld").moment, sign * (3.0 * kGravity * 0.7 + 7.0 * 2.0 - 4.0), kReactionTolerance);
  }
}

TEST(Reactions, BlockHeldOnAnInclineByItsDriver) {
  // Incline of 30°: the driver holds m g sin, the guide m g cos and the moment of a centre of mass that is off.
  Mechanism mechanism = make_empty("incline", {0.0, -kGravity}, {{"foot", {0.0, 0.0}}});
  mechanism.bodies.push_back({"block", 2.0, 0.01, {0.05, 0.02}, {{"shoe", {0.0, 0.0}}}, {}});
  const double incline = 30.0 * oracle::kDegree;
  mechanism.joints.push_back(
      {"guide", oracle::make_slide({kFrameName, "foot"}, {"block", "shoe"}, incline, incline, 0.4)});
  mechanism.drivers.push_back({"winch", DrivenSlide{"guide"}, 0.4, 0.25});
  const Started started(mechanism);
  const double weight = 2.0 * kGravity;
  EXPECT_NEAR(started.workspace.effort[0], weight * 0.5, kReactionTolerance);
  const double normal = weight * std::cos(incline);
  expect_force(started.reaction("guide"), normal * Vec2{-std::sin(incline), std::cos(incline)});
  // About the shoe: weight at (0.05, 0.02) turned by 30°.
  const double arm = 0.05 * std::cos(incline) - 0.02 * std::sin(incline);
  EXPECT_NEAR(started.reaction("guide").moment, weight * arm, kReactionTolerance);
  EXPECT_NEAR(find_driver_power(started.workspace), weight * 0.5 * 0.25, kReactionTolerance);
}

TEST(Reactions, WhirlingCrankIsHeldInward) {
  Mechanism mechanism = make_empty("crank", {0.0, -kGravity}, {{"pivot", {0.0, 0.0}}});
  mechanism.bodies.push_back(make_bar("crank", 0.2, 1.5, 0.01, {0.1, 0.0}, {}));
  oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"crank", "a"});
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.0, 20.0});
  const Started started(mechanism);
  expect_force(started.reaction("pivot"), {-1.5 * 400.0 * 0.1, 1.5 * kGravity});
  EXPECT_NEAR(started.workspace.effort[0], 1.5 * kGravity * 0.1, kReactionTolerance);
  EXPECT_NEAR(started.finder.root_moments()[0], 1.5 * kGravity * 0.1, kReactionTolerance);
}

// Drivers on a slide that closes a loop, on a tied body, and on a loose one.
std::vector<Mechanism> make_unusual_drives() {
  Mechanism closing = oracle::make_slider_crank();
  closing.name = "driven_guide";
  closing.bodies[1].start.angle_rate.reset();
  closing.drivers.push_back({"press", DrivenSlide{"guide"}, 0.21, -0.6});
  Mechanism tied = oracle::make_rigid_chain();
  tied.name = "driven_bracket";
  tied.bodies[1].start = {};
  tied.drivers.push_back({"motor", DrivenAngle{"bracket"}, 0.4, -3.0});
  Mechanism upper = oracle::make_two_slides();
  upper.name = "driven_upper";
  std::get<Prismatic>(upper.joints[1].kind).start.speed.reset();
  upper.drivers.push_back({"press", DrivenSlide{"upper"}, -0.08, 0.9});
  Mechanism both = upper;
  both.name = "driven_both";
  std::get<Prismatic>(both.joints[0].kind).start.speed.reset();
  both.drivers.insert(both.drivers.begin(), {"lift", DrivenSlide{"lower"}, 0.11, -0.7});
  both.drivers.push_back({"swing", DrivenAngle{"pendulum"}, -1.0, 3.3});
  return {closing, tied, upper, both};
}

void expect_textbook(const Mechanism& mechanism) {
  const Started started(mechanism);
  const oracle::Textbook textbook(mechanism);
  oracle::TextbookState state = textbook.make_state();
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const BodyPose& pose = started.assembly.poses[b];
    state.bodies[b] = textbook.place(static_cast<int>(b), pose.position, pose.angle, pose.velocity, pose.angle_rate);
  }
  const oracle::TextbookSolution solution = textbook.solve(state, 0.0);
  constexpr double kRelative = 1e-10;  // a well-conditioned dense solve
  double scale = 1.0;
  for (const auto& reaction : solution.reactions) scale = std::max({scale, norm(reaction.force), reaction.moment});
  for (std::size_t b = 1; b < started.motions.size(); ++b) {
    const Vec2 difference = started.motions[b].acceleration - solution.accelerations[b].center;
    EXPECT_NEAR(norm(difference), 0.0, kRelative * (1.0 + norm(solution.accelerations[b].center))) << mechanism.name;
  }
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const std::string name = mechanism.name + "." + mechanism.joints[j].name;
    EXPECT_NEAR(norm(started.finder.reactions()[j].force - solution.reactions[j].force), 0.0, kRelative * scale)
        << name;
    EXPECT_NEAR(started.finder.reactions()[j].moment, solution.reactions[j].moment, kRelative * scale) << name;
  }
  for (int d = 0; d < started.system.tables.counts.n_driven(); ++d) {
    const int driver = started.system.tables.driven[d].driver;
    EXPECT_NEAR(started.workspace.effort[d], solution.efforts[driver], kRelative * scale)
        << mechanism.name << "." << mechanism.drivers[driver].name;
  }
}

TEST(Reactions, OfUnusualDrivesAreThoseOfTheTextbook) {
  for (const Mechanism& mechanism : make_unusual_drives()) expect_textbook(mechanism);
}

}  // namespace
}  // namespace gudgeon
