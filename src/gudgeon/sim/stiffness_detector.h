// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a motion is better off with the explicit or with the stiff integrator.
#pragma once

#include <cstdint>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

/// Counts the explicit steps in a row that stability holds short, and calls for the stiff integrator once there are
/// enough of them. What that costs is compared with what explicit steps did. A trial may take as much as the steps that
/// were waited for; where it has not paid by then, the explicit ones go on, and twice as many are waited for the next
/// time. So the two together never take more than a few times what the better one would.
class StiffnessDetector {
 public:
  /// An explicit step of length h [s] with h |λ| = stiffness [1]: whether the stiff integrator is to go on.
  bool note_explicit_step(double h, double stiffness);
  /// A stiff step of length h [s] that took so many evaluations: whether the explicit one is to go on.
  bool note_stiff_step(double h, std::int64_t n_evaluations);
  /// A contact changes: what was counted says nothing about the motion behind it.
  void forget();

  void transfer(StateArchive& archive) {
    archive(n_stiff_, n_smooth_, stiff_time_, patience_, stake_, explicit_cost_, n_tried_, trial_time_, trial_cost_);
  }

 private:
  // Stiff steps in a row that call for a change at least (Hairer & Wanner 1996, IV.2), and doubled at most so often.
  static constexpr int kLeastStiff = 15;
  static constexpr int kMostStiff = kLeastStiff << 10;

  void judge();

  int n_stiff_ = 0;             // explicit steps in a row
  int n_smooth_ = 0;            // since the last stiff one
  double stiff_time_ = 0.0;     // [s] passed in the stiff ones
  int patience_ = kLeastStiff;  // stiff steps that call for a change
  double stake_ = 0.0;          // evaluations that these took
  double explicit_cost_ = 0.0;  // [1/s] evaluations
  int n_tried_ = 0;             // the stiff integrator's steps on trial
  double trial_time_ = 0.0;     // [s]
  double trial_cost_ = 0.0;     // evaluations, and what else they bring
};

}  // namespace gudgeon
