// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bounds of the gap by the least depths of what is passed.
#include "gudgeon/sim/worn_flight.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace gudgeon {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

WornFlight find_flight(const RevoluteSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  const double eccentricity = norm(motion.offset);
  const Vec2 normal = eccentricity > 0.0 ? 1.0 / eccentricity * motion.offset : Vec2{1.0, 0.0};
  const double direction = std::atan2(normal.y, normal.x);
  const double turning = eccentricity > 0.0 ? cross(normal, motion.velocity) / eccentricity : 0.0;
  return {eccentricity - (surfaces.bearing_radius - surfaces.journal_radius),
          dot(normal, motion.velocity),
          direction - motion.bearing_angle,
          turning - motion.bearing_rate,
          direction - motion.journal_angle,
          turning - motion.journal_rate};
}

WornFlight find_flight(const GuideSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  GuideSurfaces unworn{
      surfaces.direction, surfaces.side, surfaces.half_height, surfaces.half_length, surfaces.journal_radius, {}, {}};
  const GuideGap gap = find_guide_gap(unworn, motion);
  const double across = motion.bearing_angle + surfaces.direction + surfaces.side * 0.5 * std::numbers::pi;
  return {gap.penetration,   gap.penetration_rate,          gap.bearing_position,
          gap.position_rate, across - motion.journal_angle, motion.bearing_rate - motion.journal_rate};
}

// The places between `a` and `b`, and what lies beyond either within reach.
struct Passed {
  double from;
  double to;
};

Passed find_passed(double a, double rate_a, double b, double rate_b, double duration) noexcept {
  const double margin = duration * std::max(std::abs(rate_a), std::abs(rate_b));
  return {std::min(a, b) - margin, std::max(a, b) + margin};
}

double find_least(const RadialProfile& profile, double a, double rate_a, double b, double rate_b,
                  double duration) noexcept {
  // The nearest of b's turns.
  const Passed passed = find_passed(a, rate_a, a + std::remainder(b - a, kTurn), rate_b, duration);
  return profile.least_depth(passed.from, passed.to);
}

double find_least(const LineProfile& profile, double a, double rate_a, double b, double rate_b,
                  double duration) noexcept {
  const Passed passed = find_passed(a, rate_a, b, rate_b, duration);
  return profile.least_depth(passed.from, passed.to);
}

}  // namespace

WornFlight find_worn_flight(const ContactSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  return std::visit([&](const auto& kind) { return find_flight(kind, motion); }, surfaces);
}

double find_greatest_penetration(const ContactSurfaces& surfaces, const WornFlight& start, const WornFlight& end,
                                 double duration) noexcept {
  const double furthest = duration * std::max(std::abs(start.reach_rate), std::abs(end.reach_rate));
  return std::visit(
      [&](const auto& kind) {
        return std::max(start.reach, end.reach) + furthest -
               find_least(kind.bearing_wear, start.bearing_at, start.bearing_rate, end.bearing_at, end.bearing_rate,
                          duration) -
               find_least(kind.journal_wear, start.journal_at, start.journal_rate, end.journal_at, end.journal_rate,
                          duration);
      },
      surfaces);
}

}  // namespace gudgeon
