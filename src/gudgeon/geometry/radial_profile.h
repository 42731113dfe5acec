// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear depth along a circumference, as a smooth curve through the depths of equal cells.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "gudgeon/geometry/range_minimum.h"

namespace gudgeon {

/// h(φ) = Σ h_k B₃(φ/Δ − k − ½), the periodic uniform cubic B-spline whose coefficients are the cell depths.
///
/// Twice continuously differentiable, never outside the range of the cell depths, and its integral over the
/// circumference is exactly Δ Σ h_k: the curve holds the volume that was worn off. A cell's own depth spreads over
/// two cells to each side with weights 1/6, 2/3, 1/6. Cell k covers angles [k Δ, (k+1) Δ], Δ = 2π/n.
class RadialProfile {
 public:
  RadialProfile() = default;
  /// Depths [m] of at least four equal cells; all zero (or none at all) is the unworn surface.
  explicit RadialProfile(std::vector<double> cell_depths);

  struct Value {
    double depth;  ///< h [m]
    double slope;  ///< dh/dφ [m/rad]
  };

  [[nodiscard]] bool is_worn() const { return worn_; }
  [[nodiscard]] const std::vector<double>& cell_depths() const { return depths_; }

  /// No depth is less than this [m].
  [[nodiscard]] double least_depth() const { return least_depth_; }
  /// No depth between two angles [rad], from <= to, is less than this [m].
  [[nodiscard]] double least_depth(double from, double to) const noexcept;

  /// Depth and slope at an angle [rad] of any size, in the surface's own body.
  [[nodiscard]] Value eval(double angle) const noexcept;

 private:
  std::vector<double> depths_;
  std::vector<double> padded_;  // depths with the neighbours of both ends repeated, so that four in a row always exist
  double cells_per_radian_ = 0.0;
  double per_cell_ = 0.0;  // of a turn
  double least_depth_ = 0.0;
  RangeMinimum minima_;  // of the depths
  bool worn_ = false;
};

}  // namespace gudgeon
