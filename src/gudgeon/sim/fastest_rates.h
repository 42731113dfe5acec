// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How fast the fastest part of a motion is.
#pragma once

#include <algorithm>
#include <cstdint>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

/// Means over time of |λ| [1/s], the fastest rate that explicit steps feel, while contacts press and while none does.
class FastestRates {
 public:
  /// One step in so many is looked at.
  static constexpr std::int64_t kEvery = 32;

  /// A step of length h [s] with h |λ| = stiffness [1]. What is beyond the pair's stability is an error of the
  /// estimate, or would have ended the step.
  void note(double h, double stiffness, bool in_contact) noexcept {
    if (!(stiffness >= 0.0)) return;
    Sums& sums = in_contact ? in_contact_ : in_flight_;
    sums.stiffness += std::min(stiffness, kMostStiffness);
    sums.time += h;
  }
  /// 0 where nothing was noted.
  [[nodiscard]] double in_contact() const { return in_contact_.mean(); }
  [[nodiscard]] double in_flight() const { return in_flight_.mean(); }

  void transfer(StateArchive& archive) { archive(in_contact_, in_flight_); }

 private:
  static constexpr double kMostStiffness = 3.5;
  struct Sums {
    double stiffness = 0.0;
    double time = 0.0;  // [s]
    [[nodiscard]] double mean() const { return time > 0.0 ? stiffness / time : 0.0; }
  };
  Sums in_contact_;
  Sums in_flight_;
};

}  // namespace gudgeon
