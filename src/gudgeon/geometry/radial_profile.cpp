// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Evaluation of the periodic B-spline.
#include "gudgeon/geometry/radial_profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "gudgeon/geometry/uniform_spline.h"

namespace gudgeon {

RadialProfile::RadialProfile(std::vector<double> cell_depths) : depths_(std::move(cell_depths)) {
  if (!depths_.empty()) least_depth_ = *std::ranges::min_element(depths_);
  worn_ = std::ranges::any_of(depths_, [](double depth) { return depth != 0.0; });
  if (!worn_) return;
  assert(depths_.size() >= 4);
  cells_per_radian_ = static_cast<double>(depths_.size()) / (2.0 * std::numbers::pi);
  per_cell_ = 1.0 / static_cast<double>(depths_.size());
  padded_.push_back(depths_.back());
  padded_.insert(padded_.end(), depths_.begin(), depths_.end());
  padded_.insert(padded_.end(), {depths_[0], depths_[1], depths_[2]});
  minima_ = RangeMinimum(depths_);
}

double RadialProfile::least_depth(double from, double to) const noexcept {
  if (!worn_) return 0.0;
  // The depths that the curve between the angles is made of.
  const double n = static_cast<double>(depths_.size());
  double first = std::floor(from * cells_per_radian_ - 0.5) - 1.0;
  const double count = std::floor(to * cells_per_radian_ - 0.5) + 3.0 - first;
  if (!(count < n)) return least_depth_;
  first -= n * std::floor(first * per_cell_);
  const auto begin = static_cast<std::size_t>(std::clamp(first, 0.0, n - 1.0));
  const auto end = begin + static_cast<std::size_t>(count);
  if (end <= depths_.size()) return minima_.find(begin, end);
  return std::min(minima_.find(begin, depths_.size()), minima_.find(0, end - depths_.size()));
}

RadialProfile::Value RadialProfile::eval(double angle) const noexcept {
  if (!worn_) return {0.0, 0.0};
  // Position in cells from the centre of cell 0, wrapped into [0, n); rounding may leave it a hair outside, and the
  // padding covers what is too much.
  const double n = static_cast<double>(depths_.size());
  double position = angle * cells_per_radian_ - 0.5;
  position -= n * std::floor(position * per_cell_);
  if (position < 0.0) position += n;
  const double whole = std::floor(position);
  const double f = position - whole;
  // An angle too large to wrap has no depth.
  if (!(position >= 0.0 && whole <= n)) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    return {nothing, nothing};
  }
  const double* h = &padded_[static_cast<std::size_t>(whole)];
  const SplineValue spline = eval_uniform_spline(h, f);
  return {spline.value, spline.slope * cells_per_radian_};
}

}  // namespace gudgeon
