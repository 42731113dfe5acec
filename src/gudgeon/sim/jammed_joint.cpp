// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Looks ahead in ever longer steps.
#include "gudgeon/sim/jammed_joint.h"

namespace gudgeon {

namespace {

// Where steps have shrunk to nothing, a margin below this share of what it is without friction is the reason: forces
// have grown by its inverse.
constexpr double kNearlyJammed = 1e-3;
// Steps that shrank to the smallest have met what stops them within so many of it.
constexpr double kNearest = 0.1;
constexpr double kFarthest = 1e4;

}  // namespace

int find_jammed_joint(double time, double smallest_step, const std::vector<double>& y, MotionEquations& equations) {
  const Workspace& workspace = equations.workspace;
  if (workspace.friction_forces.empty()) return -1;
  std::vector<double> slope(y.size());
  const auto is_jammed = [&] { return workspace.friction_joint >= 0 && workspace.friction_margin < kNearlyJammed; };
  equations.eval(time, y.data(), slope.data());
  if (is_jammed()) return workspace.friction_joint;
  const std::vector<double> rates = slope;
  std::vector<double> ahead(y.size());
  for (double h = kNearest * smallest_step; h <= kFarthest * smallest_step; h *= 2.0) {
    for (std::size_t i = 0; i < y.size(); ++i) ahead[i] = y[i] + h * rates[i];
    equations.eval(time + h, ahead.data(), slope.data());
    if (is_jammed()) return workspace.friction_joint;
  }
  return -1;
}

}  // namespace gudgeon
