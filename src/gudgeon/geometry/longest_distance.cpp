// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Pairs of corners of the convex hull: few, however many points there are.
#include "gudgeon/geometry/longest_distance.h"

#include <algorithm>
#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <vector>

namespace gudgeon {

namespace {

using Place = boost::geometry::model::d2::point_xy<double>;
using Places = boost::geometry::model::multi_point<Place>;
using Ring = boost::geometry::model::ring<Place>;

// With fewer points, to look at every pair is quickest.
constexpr std::size_t kFewPoints = 32;

double find_longest_pair(const std::vector<Place>& places) {
  double longest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      longest = std::max(longest, norm(Vec2{places[i].x() - places[k].x(), places[i].y() - places[k].y()}));
    }
  }
  return longest;
}

}  // namespace

double find_longest_distance(std::span<const Vec2> points) {
  Places places;
  for (const Vec2 point : points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) places.emplace_back(point.x, point.y);
  }
  if (places.size() <= kFewPoints) return find_longest_pair(places);
  Ring hull;
  boost::geometry::convex_hull(places, hull);
  return find_longest_pair(hull);
}

}  // namespace gudgeon
