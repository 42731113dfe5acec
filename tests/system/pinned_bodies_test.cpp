// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which bodies are one, what that leaves in the tree, and how it is counted.
#include "gudgeon/system/pinned_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gudgeon/system/assembly.h"
#include "gudgeon/system/mobility.h"
#include "gudgeon/system/pinned_remarks.h"
#include "gudgeon/system/topology.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Bodies "a" and "b", whose axes are turned by 0.4 rad to each other when their points p, q and r meet.
constexpr double kTurned = 0.4;

Mechanism make_pair(double stretch = 1.0) {
  Mechanism mechanism = oracle::make_empty("pair", {0.0, -9.81}, {{"o", {0.0, 0.0}}});
  const Vec2 p{0.3, 0.1};
  const Vec2 q{0.7, 0.2};
  const Vec2 r{0.4, 0.5};
  const auto in_b = [&](Vec2 point) { return make_rotation(-kTurned) * (point - p); };
  mechanism.bodies.push_back({"a", 1.0, 0.1, {0.2, 0.0}, {{"o", {0.0, 0.0}}, {"p", p}, {"q", q}, {"r", r}}, {}});
  mechanism.bodies.push_back(
      {"b", 2.0, 0.2, {0.1, 0.1}, {{"p", {}}, {"q", stretch * in_b(q)}, {"r", stretch * in_b(r)}}, {}});
  oracle::add_revolute(mechanism, "o", {kFrameName, "o"}, {"a", "o"});
  oracle::add_revolute(mechanism, "p", {"a", "p"}, {"b", "p"});
  oracle::add_revolute(mechanism, "q", {"b", "q"}, {"a", "q"});
  return mechanism;
}

PinnedBodies find_pinned(const Mechanism& mechanism) {
  return find_pinned_bodies(mechanism, find_joint_ends(mechanism));
}

TEST(PinnedBodies, TwoPinsTieTheAngle) {
  const PinnedBodies pinned = find_pinned(make_pair());
  ASSERT_THAT(pinned.pairs, SizeIs(1));
  EXPECT_EQ(pinned.pairs[0].other, 1);
  EXPECT_EQ(pinned.pairs[0].joint, 2);
  EXPECT_NEAR(pinned.pairs[0].relative_angle, -kTurned, 1e-15) << "of a against b, as the joint has them";
  EXPECT_EQ(pinned.rigid_body[1], pinned.rigid_body[2]);
  EXPECT_NE(pinned.rigid_body[0], pinned.rigid_body[1]);
  EXPECT_THAT(pinned.is_inner, ElementsAre(false, true, true));
}

TEST(PinnedBodies, PinsAtUnequalDistancesTieNothing) {
  EXPECT_THAT(find_pinned(make_pair(1.0 + 1e-6)).pairs, IsEmpty());
  EXPECT_THAT(find_pinned(make_pair(1.0 + 1e-10)).pairs, SizeIs(1)) << "coordinates are written with some ten digits";
}

TEST(PinnedBodies, OnePinTiesNothing) {
  Mechanism mechanism = make_pair();
  mechanism.joints.pop_back();
  EXPECT_THAT(find_pinned(mechanism).pairs, IsEmpty());
}

TEST(PinnedBodies, PinOfAPairHoldsAThirdBodyWithItsOwn) {
  // "c" is pinned once to "a" and once to "b".
  Mechanism mechanism = make_pair();
  mechanism.bodies[2].points.push_back({"s", {0.2, 0.3}});
  const Vec2 s = Vec2{0.3, 0.1} + make_rotation(kTurned) * Vec2{0.2, 0.3};
  const double length = norm(s - Vec2{0.4, 0.5});
  mechanism.bodies.push_back(oracle::make_slender("c", length, 0.5, {}));
  oracle::add_revolute(mechanism, "r", {"a", "r"}, {"c", "a"});
  oracle::add_revolute(mechanism, "s", {"c", "b"}, {"b", "s"});
  const PinnedBodies pinned = find_pinned(mechanism);
  EXPECT_THAT(pinned.pairs, SizeIs(2));
  EXPECT_EQ(pinned.rigid_body[1], pinned.rigid_body[3]);
  const Topology topology = find_topology(mechanism);
  EXPECT_EQ(topology.counts.n_free(), 1);
  EXPECT_THAT(topology.closures, IsEmpty());
  EXPECT_THAT(topology.implied, SizeIs(2));
}

TEST(PinnedBodies, AreOneInTheTree) {
  const Topology topology = find_topology(make_pair());
  EXPECT_EQ(topology.counts.n_free(), 1);
  EXPECT_EQ(topology.bodies[1].turn, topology.bodies[2].turn);
  EXPECT_NEAR(topology.bodies[2].offset - topology.bodies[1].offset, kTurned, 1e-15);
  EXPECT_THAT(topology.closures, IsEmpty());
  EXPECT_THAT(topology.implied, ElementsAre(2));
}

TEST(PinnedBodies, CountAsTheirRowsDo) {
  const Mobility mobility = find_mobility(make_pair());
  EXPECT_EQ(mobility.n_constraint_rows, 6);
  EXPECT_EQ(mobility.n_redundant_rows, 1);
  EXPECT_EQ(mobility.n_degrees_of_freedom, 1);
  EXPECT_THAT(mobility.redundant_constraints, ElementsAre(HasSubstr("'q'")));
  EXPECT_FALSE(mobility.singular_start);
}

TEST(PinnedBodies, AThirdPinRepeatsBothRows) {
  Mechanism mechanism = make_pair();
  oracle::add_revolute(mechanism, "r", {"a", "r"}, {"b", "r"});
  const Mobility mobility = find_mobility(mechanism);
  EXPECT_EQ(mobility.n_redundant_rows, 3);
  EXPECT_EQ(mobility.n_degrees_of_freedom, 1);
}

TEST(PinnedBodies, AreAssembledTogether) {
  const Assembly assembly = assemble(make_pair());
  EXPECT_NEAR(assembly.poses[2].angle - assembly.poses[1].angle, kTurned, 1e-14);
}

TEST(PinnedBodies, MustAgreeWithGuides) {
  // A guide holds the two at another angle.
  Mechanism mechanism = make_pair();
  mechanism.joints.push_back({"guide", oracle::make_slide({"a", "o"}, {"b", "p"}, 0.0, kTurned + 0.1, 0.1)});
  const auto found = catch_diagnostics([&] { find_topology(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-060");
  EXPECT_THAT(found[0].message, HasSubstr("'q'"));
}

TEST(PinnedBodies, AreRemarkedUpon) {
  const Diagnostics diagnostics = remark_pinned_bodies(make_pair());
  ASSERT_EQ(diagnostics.items().size(), 1u);
  EXPECT_EQ(diagnostics.items()[0].code, "R-MODEL-140");
  EXPECT_EQ(diagnostics.items()[0].path, "joints.q");
  EXPECT_EQ(diagnostics.items()[0].message, "joints 'p' and 'q' hold 'b' and 'a' as one rigid body");
  EXPECT_THAT(remark_pinned_bodies(make_pair(1.1)).items(), IsEmpty());
}

}  // namespace
}  // namespace gudgeon
