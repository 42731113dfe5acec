// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Motions that slide along a break of their loads.
#include "gudgeon/sim/motion_equations.h"

#include "gudgeon/system/load_forces.h"

namespace gudgeon {

namespace {

// Rates of arguments are central differences over this share of a cycle: accelerations are linear in the loads, so
// only rounding and the break's own bend are in them.
constexpr double kDifferenceShare = 1e-6;
// A hair off the break dies down within this share of a cycle.
constexpr double kReturnShare = 0.02;

}  // namespace

// Forces on the break are those of both sides, mixed so that its argument stays where it is: ẋ = −x/τ. Accelerations
// are linear in the share.
void MotionEquations::eval_sliding(double t, const double* y, std::span<const ContactLatch> latched,
                                   Workspace& target) noexcept {
  HeldPieces& held = target.loads.held;
  double rates[2];
  for (const int side : {0, 1}) {
    held.share = side;
    eval_dynamics(*tables_, t, y, y + n_free_, latched, feedback_, target);
    std::copy_n(target.equations.begin(), n_free_, acceleration_.begin());
    rates[side] = find_argument_rate(t, y, target);
  }
  const double off = find_argument(t, y, y + n_free_, target);
  held.share = (rates[0] + off / (kReturnShare * time_scale)) / (rates[0] - rates[1]);
  eval_dynamics(*tables_, t, y, y + n_free_, latched, feedback_, target);
}

double MotionEquations::find_argument(double t, const double* q, const double* v, Workspace& target) noexcept {
  gudgeon::update_coordinates(*tables_, t, q, v, target.coordinates);
  update_point_motions(*tables_, target);
  update_breaks(*tables_, t, target);
  return target.loads.breaks[static_cast<std::size_t>(target.loads.held.surface)].argument;
}

double MotionEquations::find_argument_rate(double t, const double* y, Workspace& target) noexcept {
  const double h = kDifferenceShare * time_scale;
  double difference = 0.0;
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < n_free_; ++i) {
      moved_[i] = y[i] + sign * h * y[n_free_ + i];
      moved_[n_free_ + i] = y[n_free_ + i] + sign * h * acceleration_[i];
    }
    difference += sign * find_argument(t + sign * h, moved_.data(), moved_.data() + n_free_, target);
  }
  return difference / (2.0 * h);
}

}  // namespace gudgeon
