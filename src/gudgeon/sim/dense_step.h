// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A step of an integrator as its surroundings see it: when it was, and the solution inside it.
#pragma once

#include <cstddef>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

class DenseStep {
 public:
  [[nodiscard]] double start_time() const { return time_; }
  [[nodiscard]] double step() const { return h_; }
  /// The solution at a share in [0, 1] of the step, its first n_wanted components.
  virtual void interpolate(double share, std::size_t n_wanted, double* y) const noexcept = 0;

 protected:
  DenseStep() = default;
  DenseStep(const DenseStep&) = default;
  DenseStep& operator=(const DenseStep&) = default;
  ~DenseStep() = default;  // nobody owns a step by this base

  void transfer_times(StateArchive& archive) { archive(time_, h_); }

  double time_ = 0.0;  // [s]
  double h_ = 0.0;     // [s]
};

}  // namespace gudgeon
