// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Pairs of points, body by body.
#include "gudgeon/system/characteristic_length.h"

#include <algorithm>

namespace gudgeon {

namespace {

double find_longest_distance(const Body& body) {
  double longest = 0.0;
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      longest = std::max(longest, norm(body.points[i].position - body.points[k].position));
    }
  }
  return longest;
}

}  // namespace

double find_characteristic_length(const Mechanism& mechanism) {
  double longest = 0.0;
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    longest = std::max(longest, find_longest_distance(mechanism.bodies[b]));
  }
  if (longest == 0.0) longest = find_longest_distance(mechanism.bodies.front());
  return longest > 0.0 ? longest : 1.0;
}

}  // namespace gudgeon
