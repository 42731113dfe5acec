// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Holds loop closures: positions and rates put back onto the constraints.
#pragma once

#include <vector>

#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// Corrects a state by the least change, weighted with mass, that closes the loops again. Holds its own scratch memory.
class ClosureProjection {
 public:
  /// Closures off by no more than `tolerance` [m, m/s], and open by no more than `most_open` [m], are left alone;
  /// beside a singular position less is let pass.
  ClosureProjection(const Tables& tables, double tolerance, double most_open);
  ClosureProjection(const Tables&&, double, double) = delete;  // it keeps a reference

  /// Corrects positions, then rates, of the state y that `equations` were last evaluated for, and evaluates the slope
  /// again after each correction. Returns how many there were: 0, 1 or 2.
  int project(double t, std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations);
  /// The same however little the closures are off.
  int close(double t, std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations);
  /// Whether any closure of the workspace's coordinates is off by more than the tolerance; updates closures only.
  [[nodiscard]] bool is_needed(Workspace& workspace) const noexcept;

 private:
  struct Tolerances {
    double gap = 0.0;
    double rate = 0.0;
  };
  [[nodiscard]] Tolerances find_tolerances(const Workspace& workspace) const noexcept;
  int correct(Tolerances tolerances, double t, std::vector<double>& y, std::vector<double>& slope,
              MotionEquations& equations);

  const Tables* tables_;
  double tolerance_;
  double most_open_;
  std::vector<Vec2> residual_;
  std::vector<double> correction_;
};

/// Largest of the gaps or rates of all closures.
double find_largest(const std::vector<Vec2>& residual) noexcept;

}  // namespace gudgeon
