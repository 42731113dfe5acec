// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Evaluation of the mirrored B-spline.
#include "gudgeon/geometry/line_profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "gudgeon/geometry/uniform_spline.h"

namespace gudgeon {

LineProfile::LineProfile(std::vector<double> cell_depths, double length) : depths_(std::move(cell_depths)) {
  if (!depths_.empty()) least_depth_ = *std::ranges::min_element(depths_);
  worn_ = std::ranges::any_of(depths_, [](double depth) { return depth != 0.0; });
  if (!worn_) return;
  assert(depths_.size() >= 4 && length > 0.0);
  const std::size_t n = depths_.size();
  cells_per_meter_ = static_cast<double>(n) / length;
  padded_ = {depths_[1], depths_[0]};
  padded_.insert(padded_.end(), depths_.begin(), depths_.end());
  padded_.insert(padded_.end(), {depths_[n - 1], depths_[n - 2]});
  minima_ = RangeMinimum(depths_);
}

double LineProfile::least_depth(double from, double to) const noexcept {
  if (!worn_) return 0.0;
  // The depths that the curve between the positions is made of; beyond an end they are those within.
  const double n = static_cast<double>(depths_.size());
  const double first = std::floor(from * cells_per_meter_ + 0.5 * n - 0.5) - 1.0;
  const double end = std::floor(to * cells_per_meter_ + 0.5 * n - 0.5) + 3.0;
  if (!(first > -n && end < 2.0 * n)) return least_depth_;
  return minima_.find(static_cast<std::size_t>(std::clamp(first, 0.0, n - 2.0)),
                      static_cast<std::size_t>(std::clamp(end, 2.0, n)));
}

LineProfile::Value LineProfile::eval(double position) const noexcept {
  if (!worn_) return {0.0, 0.0};
  // In cells from the rear end; the middle of cell k is at k + ½, padded coefficient k + 2.
  const double n = static_cast<double>(depths_.size());
  const double wanted = position * cells_per_meter_ + 0.5 * n;
  if (std::isnan(wanted)) return {wanted, wanted};
  const double at = std::clamp(wanted, 0.0, n) + 0.5;
  const double whole = std::floor(at);
  const SplineValue spline = eval_uniform_spline(&padded_[static_cast<std::size_t>(whole)], at - whole);
  return {spline.value, wanted == std::clamp(wanted, 0.0, n) ? spline.slope * cells_per_meter_ : 0.0};
}

}  // namespace gudgeon
