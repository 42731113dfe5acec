// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The textbook count of mobility, and redundant constraints by name.
#include "gudgeon/system/mobility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Mobility, NineBarCountsAsInThePaper) {
  const Mobility mobility = find_mobility(oracle::make_nine_bar());
  EXPECT_EQ(mobility.n_bodies, 8);
  EXPECT_EQ(mobility.n_coordinates, 24);
  EXPECT_EQ(mobility.n_constraint_rows, 20);
  EXPECT_EQ(mobility.n_degrees_of_freedom, 4);
  EXPECT_EQ(mobility.n_unknowns, 5);
  EXPECT_EQ(mobility.n_closure_rows, 1);
  EXPECT_EQ(mobility.n_redundant_rows, 0);
  EXPECT_THAT(mobility.redundant_constraints, IsEmpty());
  EXPECT_FALSE(mobility.singular_start);
}

TEST(Mobility, IsWhatEachMechanismSaysOfItself) {
  const std::vector<std::pair<Mechanism, int>> cases{{oracle::make_pendulum_chain(5), 5},
                                                     {oracle::make_rigid_chain(), 2},
                                                     {oracle::make_slider_crank(), 1},
                                                     {oracle::make_four_bar(), 1},
                                                     {oracle::make_five_bar(), 2},
                                                     {oracle::make_parallelogram(), 1},
                                                     {oracle::make_n_four_bar(6), 1},
                                                     {oracle::make_six_bar_slide(), 1},
                                                     {oracle::make_two_slides(), 3},
                                                     {oracle::make_driven_slide(), 2},
                                                     {oracle::make_free_body_in_bearing(), 3},
                                                     {oracle::make_free_pair(), 6},
                                                     {oracle::make_slider_crank_clearance(), 2},
                                                     {make_ideal(oracle::make_nine_bar()), 0}};
  for (const auto& [mechanism, degrees] : cases) {
    const Mobility mobility = find_mobility(mechanism);
    EXPECT_EQ(mobility.n_degrees_of_freedom, degrees) << mechanism.name;
    EXPECT_EQ(mobility.n_unknowns - mobility.n_closure_rows, degrees) << mechanism.name << ": what is integrated";
  }
}

TEST(Mobility, NamesTheRedundantRow) {
  const Mobility mobility = find_mobility(oracle::make_parallelogram());
  EXPECT_EQ(mobility.n_coordinates, 12);
  EXPECT_EQ(mobility.n_constraint_rows, 12);
  EXPECT_EQ(mobility.n_redundant_rows, 1);
  EXPECT_THAT(mobility.redundant_constraints, ElementsAre(AllOf(HasSubstr("'top_2'"), HasSubstr("y direction"))));
  EXPECT_EQ(mobility.n_closure_rows, 3);
}

TEST(Mobility, SecondGuideOnOneLineIsRedundantInAngleAndLine) {
  Mechanism mechanism = oracle::make_empty("two_guides", {}, {{"guide", {0.1, 0.2}}});
  mechanism.bodies.push_back({"slider", 1.0, 0.01, {}, {{"front", {0.1, 0.0}}, {"back", {-0.1, 0.0}}}, {}});
  mechanism.joints.push_back({"one", oracle::make_slide({kFrameName, "guide"}, {"slider", "back"}, 0.3, 0.3, 0.1)});
  mechanism.joints.push_back({"two", oracle::make_slide({kFrameName, "guide"}, {"slider", "front"}, 0.3, 0.3, 0.3)});
  const Mobility mobility = find_mobility(mechanism);
  EXPECT_EQ(mobility.n_constraint_rows, 4);
  EXPECT_EQ(mobility.n_redundant_rows, 2);
  EXPECT_EQ(mobility.n_degrees_of_freedom, 1);
  EXPECT_THAT(mobility.redundant_constraints,
              ElementsAre(AllOf(HasSubstr("'two'"), HasSubstr("angle")), AllOf(HasSubstr("'two'"), HasSubstr("line"))));
}

// The rows of the second guide are nothing but rounding, and there are no others to see that by.
TEST(Mobility, SecondGuideOnASwingingArmHoldsNothing) {
  for (int k = 0; k < 30; ++k) {
    const double direction = 0.1 + 0.2 * k;
    const double turn = 2.7 - 0.31 * k;  // of the block against the arm
    const Vec2 along{std::cos(direction), std::sin(direction)};
    const auto to_block = [&](Vec2 p) { return make_rotation(-turn) * (p + 0.05 * along); };
    const Vec2 near{-0.386, 0.069};
    const Vec2 far{-0.536, 0.091};
    Mechanism mechanism = oracle::make_empty("arm", oracle::kObliqueGravity, {{"pivot", {-0.072, 0.373}}});
    mechanism.bodies.push_back({"arm",
                                0.5,
                                4e-3,
                                {0.07, -0.05},
                                {{"eye", {0.1, -0.1}}, {"near", near}, {"far", far}},
                                oracle::start_turning(-0.65, 1.0)});
    mechanism.bodies.push_back(
        {"block", 0.6, 0.015, {0.05, -0.03}, {{"near", to_block(near)}, {"far", to_block(far)}}, {}});
    oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"arm", "eye"});
    mechanism.joints.push_back({"one", oracle::make_slide({"arm", "near"}, {"block", "near"}, direction, turn, 0.05)});
    mechanism.joints.push_back({"two", oracle::make_slide({"arm", "far"}, {"block", "far"}, direction, turn, 0.05)});
    const Mobility mobility = find_mobility(mechanism);
    EXPECT_EQ(mobility.n_degrees_of_freedom, 2) << k;
    EXPECT_EQ(mobility.n_redundant_rows, 2) << k;
    EXPECT_FALSE(mobility.singular_start) << k;
  }
}

TEST(Mobility, FourBarsInOneLineStartSingular) {
  Mechanism mechanism = oracle::make_n_four_bar(2);
  for (Body& body : mechanism.bodies) {
    if (body.name.starts_with("post")) body.start = oracle::start_at(0.0);
  }
  const Mobility mobility = find_mobility(mechanism);
  EXPECT_TRUE(mobility.singular_start);
  EXPECT_EQ(mobility.n_redundant_rows, 0);
  EXPECT_EQ(mobility.n_degrees_of_freedom, 1);
  EXPECT_FALSE(find_mobility(oracle::make_n_four_bar(2)).singular_start) << "upright posts";
}

}  // namespace
}  // namespace gudgeon
