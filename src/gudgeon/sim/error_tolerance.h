// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What local error a step may have in each component of the state.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "gudgeon/model/study.h"

namespace gudgeon {

/// The state is [turns | slides and rates | bristles]. For all but bristles absolute + relative · size; an angle counts
/// as at most 1 rad, so that its error does not become harmless after many turns. A bristle's deflection is measured by
/// the one at which it slips: (absolute + relative) · scale.
class ErrorTolerance {
 public:
  ErrorTolerance(const Study& study, std::size_t n_turns, std::size_t n_rest, std::vector<double> bristle_scales = {})
      : absolute_(study.absolute_tolerance),
        relative_(study.relative_tolerance),
        n_turns_(n_turns),
        n_rest_(n_rest),
        bristles_(std::move(bristle_scales)) {
    for (double& scale : bristles_) scale *= absolute_ + relative_;
  }

  [[nodiscard]] std::size_t n_controlled() const { return n_rest_ + bristles_.size(); }

  [[nodiscard]] double find(std::size_t i, double size) const noexcept {
    if (i >= n_rest_) return bristles_[i - n_rest_];
    if (i < n_turns_) size = std::min(size, 1.0);
    return absolute_ + relative_ * size;
  }

 private:
  double absolute_;
  double relative_;
  std::size_t n_turns_;
  std::size_t n_rest_;            // components before the bristles
  std::vector<double> bristles_;  // their tolerances [m]
};

}  // namespace gudgeon
