// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How much a step may be off in the works that it sums up.
#pragma once

#include <algorithm>

namespace gudgeon {

/// Holds the local error of works to the relative tolerance: of what the step itself exchanges, and of a part of what
/// was exchanged before, so that a dead point or a rest does not hold it short; what nothing but rounding moves is off
/// by nothing. The energy balance cannot see such an error: where a driver works against a load, both sides have it.
class WorkControl {
 public:
  /// Of what was exchanged before, a step counts this share.
  static constexpr double kShareOfPast = 0.1;

  WorkControl(double relative_tolerance, double absolute_tolerance)
      : relative_(relative_tolerance), way_(absolute_tolerance) {}

  /// An error [J] by what it may be [1], with the energy exchanged [J] until the step's start and until its end, and
  /// the largest force [N] or torque [N m]: its work over a way that is nothing to the step control counts as
  /// exchanged.
  [[nodiscard]] double find_error(double error, double before, double after, double force) const noexcept {
    if (error == 0.0) return 0.0;
    return error / (relative_ * (std::max(0.0, after - before) + kShareOfPast * before + force * way_));
  }

 private:
  double relative_;
  double way_;  // [m, rad]
};

}  // namespace gudgeon
