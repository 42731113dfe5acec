// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear depth along a straight side, as a smooth curve through the depths of equal regions.
#pragma once

#include <vector>

#include "gudgeon/geometry/range_minimum.h"

namespace gudgeon {

/// h(s) = Σ h_k B₃(s/Δ − k − ½), the uniform cubic B-spline of the region depths, mirrored at both ends of the side.
///
/// Twice continuously differentiable, never outside the range of the region depths, and its integral over the side is
/// exactly Δ Σ h_k: what a region near an end spreads beyond it comes back mirrored. Region k covers [k Δ, (k+1) Δ]
/// from the side's rear end, Δ = length/n; s is counted from the middle of the side. Beyond an end the depth stays the
/// end's.
class LineProfile {
 public:
  LineProfile() = default;
  /// Depths [m] of at least four equal regions of a side of that length [m]; all zero (or none) is the unworn side.
  LineProfile(std::vector<double> region_depths, double length);

  struct Value {
    double depth;  ///< h [m]
    double slope;  ///< dh/ds [1]
  };

  [[nodiscard]] bool is_worn() const { return worn_; }
  [[nodiscard]] const std::vector<double>& region_depths() const { return depths_; }

  /// No depth is less than this [m].
  [[nodiscard]] double least_depth() const { return least_depth_; }
  /// No depth between two positions [m], from <= to, is less than this [m].
  [[nodiscard]] double least_depth(double from, double to) const noexcept;

  /// Depth and slope at a position [m] from the middle of the side.
  [[nodiscard]] Value eval(double position) const noexcept;

 private:
  std::vector<double> depths_;
  std::vector<double> padded_;  // depths with both ends mirrored, so that four in a row always exist
  double regions_per_meter_ = 0.0;
  double least_depth_ = 0.0;
  RangeMinimum minima_;  // of the depths
  bool worn_ = false;
};

}  // namespace gudgeon
