// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One linear correction for positions and one for rates, with the factors at hand:
// H dq + Jᵀ μ = 0,  J dq = −residual: the least ½ dqᵀ H dq (docs/theory/dynamics.md, Eq. D15)
#include "gudgeon/sim/closure_projection.h"

#include <algorithm>
#include <cmath>

namespace gudgeon {

namespace {

// A correction moves coordinates by about the gap over the size of the mechanism; this much more is not a correction.
constexpr double kMostMoved = 1e4;

}  // namespace

double find_largest(const std::vector<Vec2>& residual) noexcept {
  double largest = 0.0;
  for (const Vec2 r : residual) largest = std::max(largest, norm(r));
  return largest;
}

ClosureProjection::ClosureProjection(const Tables& tables, double tolerance, double most_open)
    : tables_(&tables),
      tolerance_(tolerance),
      most_open_(most_open),
      residual_(tables.closures.size()),
      correction_(static_cast<std::size_t>(tables.counts.n_free())) {}

// What a gap does to the motion grows towards a singular position, and so does the care that it takes.
ClosureProjection::Tolerances ClosureProjection::find_tolerances(const Workspace& workspace) const noexcept {
  const double closeness = std::max(1.0, find_singular_closeness(*tables_, workspace));
  return {std::min(tolerance_, most_open_) / closeness, tolerance_ / closeness};
}

bool ClosureProjection::is_needed(Workspace& workspace) const noexcept {
  update_closures(*tables_, workspace);
  const auto [gap, rate] = find_tolerances(workspace);
  // NaN needs it too.
  return !(find_largest(workspace.closure_gap) <= gap && find_largest(workspace.closure_rate) <= rate);
}

int ClosureProjection::project(double t, std::vector<double>& y, std::vector<double>& slope,
                               MotionEquations& equations) {
  return correct(find_tolerances(equations.workspace), t, y, slope, equations);
}

int ClosureProjection::close(double t, std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations) {
  return correct({}, t, y, slope, equations);
}

int ClosureProjection::correct(Tolerances tolerances, double t, std::vector<double>& y, std::vector<double>& slope,
                               MotionEquations& equations) {
  Workspace& workspace = equations.workspace;
  if (correction_.empty()) return 0;
  int n_corrections = 0;
  for (const bool rates : {false, true}) {
    const std::vector<Vec2>& current = rates ? workspace.closure_rate : workspace.closure_gap;
    if (find_largest(current) <= (rates ? tolerances.rate : tolerances.gap)) continue;
    residual_ = current;
    find_correction(*tables_, residual_, workspace, correction_.data());
    // Beside a singular position a correction would move the mechanism far for a gap that is next to nothing.
    const double moved = *std::ranges::max_element(correction_, {}, [](double x) { return std::abs(x); });
    if (std::abs(moved) <= kMostMoved * find_largest(residual_)) {
      const std::size_t first = rates ? correction_.size() : 0;
      for (std::size_t i = 0; i < correction_.size(); ++i) y[first + i] += correction_[i];
      ++n_corrections;
    }
    // Also after a correction that is not made: it was solved for where the accelerations stood.
    equations.eval(t, y.data(), slope.data());
  }
  return n_corrections;
}

}  // namespace gudgeon
