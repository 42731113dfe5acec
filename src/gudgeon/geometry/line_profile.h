// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear depth along a straight side, as a smooth curve through the depths of equal cells.
#pragma once

#include <vector>

#include "gudgeon/geometry/range_minimum.h"

namespace gudgeon {

/// h(s) = Σ h_k B₃(s/Δ − k − ½), the uniform cubic B-spline of the cell depths, mirrored at both ends of the side.
///
/// Twice continuously differentiable, never outside the range of the cell depths, and its integral over the side is
/// exactly Δ Σ h_k: what a cell near an end spreads beyond it comes back mirrored. Cell k covers [k Δ, (k+1) Δ]
/// from the side's rear end, Δ = length/n; s is counted from the middle of the side. Beyond an end the depth stays the
/// end's.
class LineProfile {
 public:
  LineProfile() = default;
  /// Depths [m] of at least four equal cells of a side of that length [m]; all zero (or none) is the unworn side.
  LineProfile(std::vector<double> cell_depths, double length);

  struct Value {
    double depth;  ///< h [m]
    double slope;  ///< dh/ds [1]
  };

  [[nodiscard]] bool is_worn() const { return worn_; }
  [[nodiscard]] const std::vector<double>& cell_depths() const { return depths_; }

  /// No depth is less than this [m].
  [[nodiscard]] double least_depth() const { return least_depth_; }
  /// No depth between two positions [m], from <= to, is less than this [m].
  [[nodiscard]] double least_depth(double from, double to) const noexcept;

  /// Depth and slope at a position [m] from the middle of the side.
  [[nodiscard]] Value eval(double position) const noexcept;

 private:
  std::vector<double> depths_;
  std::vector<double> padded_;  // depths with both ends mirrored, so that four in a row always exist
  double cells_per_meter_ = 0.0;
  double least_depth_ = 0.0;
  RangeMinimum minima_;  // of the depths
  bool worn_ = false;
};

}  // namespace gudgeon
