// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Groups of tied angles: who belongs together, at which offsets, and rings that agree or do not.
#include "gudgeon/system/angle_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

AngleGroups find_groups(const Mechanism& mechanism) {
  const std::vector<JointEnds> ends = find_joint_ends(mechanism);
  return find_angle_groups(mechanism, ends, find_pinned_bodies(mechanism, ends).pairs);
}

using testing::ElementsAre;
using testing::IsEmpty;

// Three bars, b tied to a at 0.3 rad and c to b at −1.1 rad, and c back to a at the given angle.
Mechanism make_ring(double closing_angle) {
  Mechanism mechanism = oracle::make_empty("ring", {}, {{"pivot", {}}});
  for (const char* name : {"a", "b", "c"}) mechanism.bodies.push_back(oracle::make_slender(name, 0.1, 1.0, {}));
  oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"a", "a"});
  mechanism.joints.push_back({"ab", Rigid{{"a", "b"}, {"b", "a"}, 0.3}});
  mechanism.joints.push_back({"bc", oracle::make_slide({"b", "b"}, {"c", "a"}, 0.0, -1.1, 0.0)});
  mechanism.joints.push_back({"ca", oracle::make_slide({"c", "b"}, {"a", "a"}, 0.0, closing_angle, 0.0)});
  return mechanism;
}

TEST(AngleGroups, RevoluteAndClearanceJointsTieNothing) {
  const Mechanism mechanism = oracle::make_nine_bar();
  const AngleGroups groups = find_groups(mechanism);
  // Eight moving bodies, of which only the slider is tied: to the frame.
  EXPECT_EQ(groups.n_groups, 8);
  EXPECT_EQ(groups.group[0], 0);
  EXPECT_EQ(groups.group[find_body(mechanism, "slider_9")], 0);
  EXPECT_THAT(groups.ties, ElementsAre(find_joint(mechanism, "guide")));
  EXPECT_THAT(groups.redundant, IsEmpty());
  for (std::size_t b = 1; b + 1 < mechanism.bodies.size(); ++b) EXPECT_NE(groups.group[b], 0);
}

TEST(AngleGroups, OffsetsFollowJointsWrittenEitherWay) {
  const AngleGroups groups = find_groups(oracle::make_two_slides());
  // lower: θ_table = 0.15; upper, written from the carriage: θ_table − θ_carriage = −0.25.
  EXPECT_THAT(groups.group, ElementsAre(0, 0, 0, 1));
  EXPECT_EQ(groups.offset[0], 0.0);
  EXPECT_DOUBLE_EQ(groups.offset[1], 0.15);
  EXPECT_DOUBLE_EQ(groups.offset[2], 0.40);
  EXPECT_EQ(groups.offset[3], 0.0);
}

TEST(AngleGroups, AgreeingRingHasOneRedundantTie) {
  for (const double turns : {0.0, 2.0 * std::numbers::pi, -4.0 * std::numbers::pi}) {
    // θ_a − θ_c = 1.1 − 0.3, in any number of turns
    const AngleGroups groups = find_groups(make_ring(0.8 + turns));
    EXPECT_EQ(groups.n_groups, 2);
    EXPECT_EQ(groups.ties.size(), 2u);
    EXPECT_EQ(groups.redundant.size(), 1u);
    EXPECT_NEAR(std::remainder(groups.offset[2] - groups.offset[1] - 0.3, 2.0 * std::numbers::pi), 0.0, 1e-14);
    EXPECT_NEAR(std::remainder(groups.offset[3] - groups.offset[2] + 1.1, 2.0 * std::numbers::pi), 0.0, 1e-14);
  }
}

TEST(AngleGroups, ConflictingRingIsAnError) {
  for (const double wrong : {1e-8, -1e-8, 0.5, std::numbers::pi}) {
    const auto found = catch_diagnostics([&] { find_groups(make_ring(0.8 + wrong)); });
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].code, "E-MODEL-060");
    EXPECT_THAT(found[0].path, testing::MatchesRegex("joints\\.(ab|bc|ca)\\.relative_angle"));
    EXPECT_THAT(found[0].notes, testing::Not(IsEmpty()));
  }
  EXPECT_NO_THROW(find_groups(make_ring(0.8 + 1e-10))) << "angles are written with some ten digits";
}

}  // namespace
}  // namespace gudgeon
