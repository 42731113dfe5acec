// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The gap of a revolute joint: reduction to e − c, its rate against finite differences, and turning of everything.
#include "gudgeon/geometry/revolute_gap.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace gudgeon {
namespace {

RadialProfile make_wear(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 4e-5);
  std::vector<double> depths(n);
  for (double& depth : depths) depth = uniform(random);
  return RadialProfile(depths);
}

RevoluteSurfaces make_surfaces(bool bearing_worn, bool journal_worn) {
  RevoluteSurfaces surfaces{15e-3, 14.5e-3, {}, {}};
  if (bearing_worn) surfaces.bearing_wear = make_wear(20, 1);
  if (journal_worn) surfaces.journal_wear = make_wear(26, 2);
  return surfaces;
}

// A journal that circles in its bearing while both bodies turn, at different rates and opposite senses.
RelativeMotion make_motion(double t) {
  const double radius = 5.2e-4 + 3e-5 * std::sin(5.0 * t);
  const double radius_rate = 1.5e-4 * std::cos(5.0 * t);
  const double direction = 0.4 - 3.0 * t;
  const Vec2 normal{std::cos(direction), std::sin(direction)};
  return {
      radius * normal, radius_rate * normal + (-3.0 * radius) * perp(normal), 1.3 + 2.0 * t, -0.7 - 4.5 * t, 2.0, -4.5};
}

TEST(RevoluteGap, UnwornIsEccentricityMinusClearance) {
  const RevoluteSurfaces surfaces = make_surfaces(false, false);
  const RevoluteGap gap = find_revolute_gap(surfaces, {{-0.3e-3, 0.4e-3}, {0.1, 0.2}, 0.3, 0.7, 5.0, -8.0});
  EXPECT_DOUBLE_EQ(gap.eccentricity, 0.5e-3);
  EXPECT_NEAR(gap.penetration, 0.0, 1e-17);  // 0.5 mm minus 0.5 mm, of radii of 15 mm
  EXPECT_DOUBLE_EQ(gap.normal.x, -0.6);
  EXPECT_DOUBLE_EQ(gap.normal.y, 0.8);
  EXPECT_DOUBLE_EQ(gap.penetration_rate, 0.1);  // −0.6 · 0.1 + 0.8 · 0.2
  EXPECT_EQ(gap.bearing_radius, 15e-3);
  EXPECT_EQ(gap.journal_radius, 14.5e-3);
  EXPECT_EQ(gap.bearing_gradient, 0.0);
  EXPECT_EQ(gap.journal_gradient, 0.0);
  EXPECT_EQ(gap.gradient, gap.normal);
  EXPECT_NEAR(surfaces.least_clearance(), 0.5e-3, 1e-17);
}

TEST(RevoluteGap, ConcentricIsFullClearanceAlongX) {
  for (const bool worn : {false, true}) {
    const RevoluteGap gap =
        find_revolute_gap(make_surfaces(worn, worn), {{0.0, 0.0}, {-2.0, 3.0}, 0.3, 0.7, 5.0, -8.0});
    EXPECT_EQ(gap.normal, (Vec2{1.0, 0.0}));
    EXPECT_NEAR(gap.penetration, -0.5e-3, 1e-17);
    EXPECT_EQ(gap.penetration_rate, -2.0);
  }
}

// Wear is measured in the surface's own body: with it on one cell only, that cell must be turned to the contact.
TEST(RevoluteGap, FindsWearWhereItIsInEachBody) {
  std::vector<double> depths(12, 0.0);
  depths[4] = 6e-5;  // centre at 4.5 · 30° = 135°
  const double worn_at = 0.75 * std::numbers::pi;
  const double body_angle = 0.9;
  for (const bool on_bearing : {true, false}) {
    RevoluteSurfaces surfaces = make_surfaces(false, false);
    (on_bearing ? surfaces.bearing_wear : surfaces.journal_wear) = RadialProfile(depths);
    const auto find = [&](double direction) {
      RelativeMotion motion{6e-4 * Vec2{std::cos(direction), std::sin(direction)}, {}, 2.2, 2.2, 0.0, 0.0};
      (on_bearing ? motion.bearing_angle : motion.journal_angle) = body_angle;
      return find_revolute_gap(surfaces, motion);
    };
    // Rounding of lengths of 15 mm; the spline has two thirds of a lone depth at its centre.
    const RevoluteGap at = find(body_angle + worn_at);
    EXPECT_NEAR(at.bearing_radius, on_bearing ? 15e-3 + 4e-5 : 15e-3, 1e-16);
    EXPECT_NEAR(at.journal_radius, on_bearing ? 14.5e-3 : 14.5e-3 - 4e-5, 1e-16);
    EXPECT_NEAR(at.penetration, 6e-4 - 5e-4 - 4e-5, 1e-16);
    EXPECT_NEAR(std::remainder(at.direction - body_angle - worn_at, 2.0 * std::numbers::pi), 0.0, 1e-15);
    EXPECT_NEAR(find(body_angle - worn_at).penetration, 1e-4, 1e-16);
    // A little before the middle a bearing's radius still grows along the angle, a journal's shrinks.
    const RevoluteGap before = find(body_angle + worn_at - 0.1);
    // A body that turns on moves the place under the contact back along its surface.
    EXPECT_EQ(before.bearing_gradient > 0.0, on_bearing);
    EXPECT_EQ(before.journal_gradient > 0.0, !on_bearing);
  }
}

TEST(RevoluteGap, RatesAreDerivatives) {
  constexpr double kStep = 1e-6;
  for (const auto& [bearing_worn, journal_worn] :
       {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
    const RevoluteSurfaces surfaces = make_surfaces(bearing_worn, journal_worn);
    for (double t = 0.0; t < 2.0; t += 0.037) {
      const RevoluteGap before = find_revolute_gap(surfaces, make_motion(t - kStep));
      const RevoluteGap at = find_revolute_gap(surfaces, make_motion(t));
      const RevoluteGap after = find_revolute_gap(surfaces, make_motion(t + kStep));
      const auto difference = [&](double RevoluteGap::*member) {
        return (after.*member - before.*member) / (2.0 * kStep);
      };
      // Lengths of 15 mm round to 2e-18 m, which is 2e-12 m/s over the step; rates are up to 1e-3 m/s.
      constexpr double kTolerance = 2e-11;
      EXPECT_NEAR(at.penetration_rate, difference(&RevoluteGap::penetration), kTolerance) << t;
      const RelativeMotion motion = make_motion(t);
      EXPECT_NEAR(at.penetration_rate,
                  dot(at.gradient, motion.velocity) + at.bearing_gradient * motion.bearing_rate +
                      at.journal_gradient * motion.journal_rate,
                  1e-15)
          << "the gradient gives the rate";
      EXPECT_NEAR(at.bearing_radius_rate, difference(&RevoluteGap::bearing_radius), kTolerance) << t;
      EXPECT_NEAR(at.journal_radius_rate, difference(&RevoluteGap::journal_radius), kTolerance) << t;
    }
  }
}

TEST(RevoluteGap, DoesNotChangeWhenEverythingIsTurned) {
  const RevoluteSurfaces surfaces = make_surfaces(true, true);
  for (const double turn : {-2.9, 0.4, 1.7, 13.0}) {
    const Rotation rotation = make_rotation(turn);
    for (double t = 0.0; t < 2.0; t += 0.11) {
      RelativeMotion motion = make_motion(t);
      const RevoluteGap before = find_revolute_gap(surfaces, motion);
      motion.offset = rotation * motion.offset;
      motion.velocity = rotation * motion.velocity;
      motion.bearing_angle += turn;
      motion.journal_angle += turn;
      const RevoluteGap after = find_revolute_gap(surfaces, motion);
      EXPECT_NEAR(after.penetration, before.penetration, 1e-16);            // lengths of 15 mm
      EXPECT_NEAR(after.penetration_rate, before.penetration_rate, 1e-15);  // rates of 2 mm/s
      EXPECT_NEAR(after.bearing_radius, before.bearing_radius, 1e-16);
      EXPECT_NEAR(after.journal_gradient, before.journal_gradient, 1e-15);
      EXPECT_NEAR(norm(after.gradient - rotation * before.gradient), 0.0, 1e-14);
      EXPECT_NEAR(norm(after.normal - rotation * before.normal), 0.0, 1e-15);
    }
  }
}

TEST(RevoluteGap, LeastClearanceIsALowerBound) {
  const RevoluteSurfaces surfaces = make_surfaces(true, true);
  EXPECT_GT(surfaces.least_clearance(), 0.5e-3);
  for (double t = 0.0; t < 6.0; t += 0.01) {
    const RevoluteGap gap = find_revolute_gap(surfaces, make_motion(t));
    EXPECT_GE(gap.bearing_radius - gap.journal_radius, surfaces.least_clearance());
  }
}

}  // namespace
}  // namespace gudgeon
