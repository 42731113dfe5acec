// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Looks ahead in ever longer steps.
#include "gudgeon/sim/lost_load.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/system/load_forces.h"

namespace gudgeon {

namespace {

// Steps that shrank to the smallest have met what stops them within so many of it.
constexpr double kNearest = 0.1;
constexpr double kFarthest = 1e4;

}  // namespace

int find_load_in_the_way(double time, double smallest_step, const std::vector<double>& y, MotionEquations& equations) {
  std::vector<double> slope(y.size());
  equations.eval(time, y.data(), slope.data());
  if (const int lost = find_lost_load(equations.workspace); lost >= 0) return lost;
  // At a singular position nothing ahead is known.
  if (!std::ranges::all_of(slope, [](double s) { return std::isfinite(s); })) return -1;
  const std::vector<double> rates = slope;
  std::vector<double> ahead(y.size());
  for (double h = kNearest * smallest_step; h <= kFarthest * smallest_step; h *= 2.0) {
    for (std::size_t i = 0; i < y.size(); ++i) ahead[i] = y[i] + h * rates[i];
    equations.eval(time + h, ahead.data(), slope.data());
    if (const int lost = find_lost_load(equations.workspace); lost >= 0) return lost;
  }
  return -1;
}

}  // namespace gudgeon
