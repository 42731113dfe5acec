// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The gap of a corner in a slot: on paper, its rates against finite differences, where wear is, and its bound.
#include "gudgeon/geometry/guide_gap.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

#include "tests/geometry/guide_motion.h"

namespace gudgeon {
namespace {

using test::make_guide;
using test::make_guide_motion;

constexpr double kSides[] = {1.0, -1.0};
constexpr std::pair<bool, bool> kWorn[] = {{false, false}, {true, false}, {false, true}, {true, true}};

TEST(GuideGap, UnwornIsHeightAndRadiusBeyondTheSide) {
  GuideSurfaces surfaces = make_guide(1.0, false, false);
  surfaces.direction = 0.0;
  const RelativeMotion motion{{0.08, 0.0215}, {0.4, -0.3}, 0.0, 0.9, 2.0, 7.0};
  const GuideGap left = find_guide_gap(surfaces, motion);
  EXPECT_EQ(left.normal, (Vec2{0.0, 1.0}));
  EXPECT_NEAR(left.penetration, 0.5e-3, 1e-17);  // 21.5 + 5 − 26 mm
  EXPECT_NEAR(left.penetration_rate, -0.3 - 2.0 * 0.08, 1e-15) << "the side turns away with the slot";
  EXPECT_DOUBLE_EQ(left.bearing_position, 0.08);
  EXPECT_NEAR(left.position_rate, 0.4 + 2.0 * 0.0215, 1e-15);
  EXPECT_EQ(left.relative_radius, 5e-3);
  EXPECT_TRUE(std::isinf(left.bearing_radius));
  // The middle of the overlap is half of it inside either surface.
  EXPECT_NEAR(left.bearing_lever, 26e-3 + 0.25e-3, 1e-17);
  EXPECT_NEAR(left.journal_lever, 5e-3 - 0.25e-3, 1e-17);
  surfaces.side = -1.0;
  const GuideGap right = find_guide_gap(surfaces, motion);
  EXPECT_EQ(right.normal, (Vec2{0.0, -1.0}));
  EXPECT_NEAR(right.penetration, -42.5e-3, 1e-17);
  EXPECT_NEAR(right.penetration_rate, 0.3 + 2.0 * 0.08, 1e-15);
}

TEST(GuideGap, RatesAreDerivatives) {
  constexpr double kStep = 1e-5;
  for (const double side : kSides) {
    for (const auto& [bearing_worn, journal_worn] : kWorn) {
      const GuideSurfaces surfaces = make_guide(side, bearing_worn, journal_worn);
      for (double t = 0.0; t < 2.0; t += 0.037) {
        const GuideGap before = find_guide_gap(surfaces, make_guide_motion(surfaces, t - kStep));
        const GuideGap at = find_guide_gap(surfaces, make_guide_motion(surfaces, t));
        const GuideGap after = find_guide_gap(surfaces, make_guide_motion(surfaces, t + kStep));
        const auto difference = [&](double GuideGap::*member) {
          return (after.*member - before.*member) / (2.0 * kStep);
        };
        // Lengths of 0.1 m round to 1e-17 m, 1e-12 m/s over the step; its square takes 1e-10 of depths that change
        // with 0.2 m/s over cells of 15 mm, 1e-5 m · (2 π · 13/s)³.
        constexpr double kTolerance = 2e-9;
        EXPECT_NEAR(at.penetration_rate, difference(&GuideGap::penetration), kTolerance) << t;
        EXPECT_NEAR(at.reach_rate, difference(&GuideGap::reach), kTolerance) << t;
        EXPECT_NEAR(at.position_rate, difference(&GuideGap::bearing_position), kTolerance) << t;
        EXPECT_NEAR(at.journal_radius_rate, difference(&GuideGap::journal_radius), kTolerance) << t;
        EXPECT_NEAR(at.relative_radius_rate, difference(&GuideGap::relative_radius) / at.relative_radius,
                    kTolerance / 5e-3);
        const RelativeMotion motion = make_guide_motion(surfaces, t);
        EXPECT_NEAR(at.penetration_rate,
                    dot(at.gradient, motion.velocity) + at.bearing_gradient * motion.bearing_rate +
                        at.journal_gradient * motion.journal_rate,
                    1e-15)
            << "the gradient gives the rate";
      }
    }
  }
}

// A force along the gradient turns nothing by itself: the gap does not change when everything is turned.
TEST(GuideGap, DoesNotChangeWhenEverythingIsTurned) {
  for (const double side : kSides) {
    const GuideSurfaces surfaces = make_guide(side, true, true);
    for (const double turn : {-2.9, 0.4, 13.0}) {
      const Rotation rotation = make_rotation(turn);
      for (double t = 0.0; t < 2.0; t += 0.11) {
        RelativeMotion motion = make_guide_motion(surfaces, t);
        const GuideGap before = find_guide_gap(surfaces, motion);
        motion.offset = rotation * motion.offset;
        motion.velocity = rotation * motion.velocity;
        motion.bearing_angle += turn;
        motion.journal_angle += turn;
        const GuideGap after = find_guide_gap(surfaces, motion);
        EXPECT_NEAR(after.penetration, before.penetration, 1e-15);  // lengths of 0.1 m, turned
        EXPECT_NEAR(after.penetration_rate, before.penetration_rate, 1e-15);
        EXPECT_NEAR(after.bearing_position, before.bearing_position, 1e-15);
        EXPECT_NEAR(norm(after.gradient - rotation * before.gradient), 0.0, 1e-14);
        EXPECT_NEAR(cross(motion.offset, after.gradient) + after.bearing_gradient + after.journal_gradient, 0.0, 1e-16);
      }
    }
  }
}

// The side has its wear along the slot, the corner has it towards the side, in its own body.
TEST(GuideGap, FindsWearWhereItIsInEachBody) {
  for (const double side : kSides) {
    std::vector<double> depths(12, 0.0);
    depths[8] = 6e-5;  // of 12 cells of 50 mm: middle at 125 mm; of a circle: at 255°
    GuideSurfaces worn_side = make_guide(side, false, false);
    worn_side.bearing_wear = LineProfile(depths, 0.6);
    const auto find = [&](const GuideSurfaces& surfaces, double s, double journal_angle) {
      const Vec2 along{std::cos(0.4 + surfaces.direction), std::sin(0.4 + surfaces.direction)};
      const Vec2 offset = s * along + side * 21.05e-3 * perp(along);
      return find_guide_gap(surfaces, {offset, {}, 0.4, journal_angle, 0.0, 0.0});
    };
    // The spline has two thirds of a lone depth at its centre.
    EXPECT_NEAR(find(worn_side, 0.125, 0.0).penetration, 5e-5 - 4e-5, 1e-16);
    EXPECT_NEAR(find(worn_side, 0.125, 0.0).bearing_depth, 4e-5, 1e-16);
    EXPECT_NEAR(find(worn_side, -0.125, 0.0).penetration, 5e-5, 1e-16);
    EXPECT_LT(dot(find(worn_side, 0.11, 0.0).gradient, {std::cos(1.1), std::sin(1.1)}), 0.0) << "it grows deeper ahead";

    GuideSurfaces worn_corner = make_guide(side, false, false);
    worn_corner.journal_wear = RadialProfile(depths);
    const double normal = 0.4 + 0.7 + side * 0.5 * std::numbers::pi;
    const double turned_there = normal - 255.0 / 180.0 * std::numbers::pi;
    EXPECT_NEAR(find(worn_corner, 0.0, turned_there).journal_radius, 5e-3 - 4e-5, 1e-16);
    EXPECT_NEAR(find(worn_corner, 0.0, turned_there).penetration, 5e-5 - 4e-5, 1e-16);
    EXPECT_NEAR(find(worn_corner, 0.0, turned_there + std::numbers::pi).penetration, 5e-5, 1e-16);
  }
}

TEST(GuideGap, ReachIsAnUpperBoundOfThePenetration) {
  for (const double side : kSides) {
    const GuideSurfaces surfaces = make_guide(side, true, true);
    double nearest = 1.0;
    for (double t = 0.0; t < 12.0; t += 1e-3) {
      const GuideGap gap = find_guide_gap(surfaces, make_guide_motion(surfaces, t));
      ASSERT_GE(gap.reach, gap.penetration);
      nearest = std::min(nearest, gap.reach - gap.penetration);
    }
    EXPECT_LT(nearest, 5e-6) << "and no loose one";
  }
}

}  // namespace
}  // namespace gudgeon
