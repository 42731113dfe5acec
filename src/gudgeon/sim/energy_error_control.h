// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How much a step may add to what the energy balance is off by.
#pragma once

#include <algorithm>
#include <cmath>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

/// Keeps the energy balance's residual below kLargestResidual of the energy exchanged. A step may add the same share of
/// what it exchanges itself, and a part of what steps before it have left unused; what brings the residual nearer to
/// zero is free. So a dead point, a rest or a knock, in which next to nothing is exchanged, does not hold its step
/// short.
class EnergyErrorControl {
 public:
  /// Of the energy exchanged [1]. The energy balance is judged by 1e-6; projections add to its residual, too.
  static constexpr double kLargestResidual = 3e-7;
  /// Of what is left, a step may use this share: the next ones may need it as well.
  static constexpr double kShareOfRest = 0.1;
  /// Speeds are known to 1e-7 where the energy balance holds steps.
  static constexpr double kKineticKnown = 2e-7;

  /// Where attempts start: the energy balance's residual and the energy exchanged until there [J].
  void begin(double residual, double exchanged) noexcept {
    residual_ = std::abs(residual);
    exchanged_ = exchanged;
  }

  /// What an attempt that ends with these has added to the residual's size, by what it may add [1].
  [[nodiscard]] double find_error(double residual, double exchanged) const noexcept {
    const double added = std::abs(residual) - residual_;
    return added <= 0.0 ? 0.0 : find_share(added, exchanged);
  }

  /// An energy [J] by what such an attempt may add [1]; beside a kinetic energy [J], what that is known to counts, too.
  [[nodiscard]] double find_share(double energy, double exchanged, double kinetic = 0.0) const noexcept {
    const double rest = std::max(0.0, kLargestResidual * exchanged_ - residual_) + kKineticKnown * kinetic;
    return energy / (kLargestResidual * (exchanged - exchanged_) + kShareOfRest * rest);
  }

  void transfer(StateArchive& archive) { archive(residual_, exchanged_); }

 private:
  double residual_ = 0.0;
  double exchanged_ = 0.0;
};

}  // namespace gudgeon
