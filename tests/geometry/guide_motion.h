// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A circle that slides along one side of a slot, pressed into it, while both bodies turn.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "gudgeon/geometry/guide_gap.h"

namespace gudgeon::test {

inline std::vector<double> make_depths(std::size_t n, double deepest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.1 * deepest, deepest);
  std::vector<double> depths(n);
  for (double& depth : depths) depth = uniform(random);
  return depths;
}

/// A corner of 5 mm and a side of 600 mm, worn by 10 um at most where asked.
inline GuideSurfaces make_guide(double side, bool bearing_worn, bool journal_worn) {
  GuideSurfaces surfaces{0.7, side, 26e-3, 0.3, 5e-3, {}, {}};
  if (bearing_worn) surfaces.bearing_wear = LineProfile(make_depths(40, 1e-5, 1), 0.6);
  if (journal_worn) surfaces.journal_wear = RadialProfile(make_depths(26, 1e-5, 2));
  return surfaces;
}

/// To and fro by 100 mm; the unworn surfaces overlap by 40 to 60 um. The bodies turn against each other.
inline RelativeMotion make_guide_motion(const GuideSurfaces& surfaces, double t) {
  const double bearing_angle = 1.3 + 0.5 * t;
  const double slot = bearing_angle + surfaces.direction;
  const Vec2 along{std::cos(slot), std::sin(slot)};
  const Vec2 normal = surfaces.side * perp(along);
  const double height = surfaces.half_height - surfaces.journal_radius + 5e-5 + 1e-5 * std::sin(5.0 * t);
  const Vec2 offset = 0.1 * std::sin(2.0 * t) * along + height * normal;
  const Vec2 velocity = 0.2 * std::cos(2.0 * t) * along + 5e-5 * std::cos(5.0 * t) * normal + 0.5 * perp(offset);
  return {offset, velocity, bearing_angle, -0.7 + 0.9 * t, 0.5, 0.9};
}

}  // namespace gudgeon::test
