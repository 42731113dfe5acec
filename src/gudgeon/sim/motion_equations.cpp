// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Motions that slide along a break of their loads.
#include "gudgeon/sim/motion_equations.h"

#include <Eigen/LU>

#include "gudgeon/system/load_forces.h"

namespace gudgeon {

namespace {

// Rates of arguments are central differences over this share of a cycle: accelerations are linear in the loads, so
// only rounding and the break's own bend are in them.
constexpr double kDifferenceShare = 1e-6;
// A hair off the break dies down within this share of a cycle.
constexpr double kReturnShare = 0.02;
// Friction of ideal joints bends what is else linear in the shares, by no more than it is of the loads.
constexpr int kFrictionPasses = 4;

}  // namespace

// Forces on the breaks are those of both sides, mixed so that each argument stays where it is: ẋ = −x/τ. Accelerations
// are linear in the shares.
void MotionEquations::eval_sliding(double t, const double* y, std::span<const ContactMode> modes,
                                   Workspace& target) noexcept {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostSlides, kMostSlides>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostSlides, 1>;
  HeldPieces& held = target.loads.held;
  const int n = held.n_slides;
  const std::span<const int> surfaces(held.surfaces.data(), static_cast<std::size_t>(n));
  const auto eval_rates = [&](double* rates) {
    eval_dynamics(*tables_, t, y, y + n_free_, modes, feedback_, target);
    find_argument_rates(t, y, surfaces, target, rates);
  };
  Vector away(n);
  Matrix effect(n, n);
  for (int k = 0; k < n; ++k) held.set_share(k, 0.0);
  eval_rates(away.data());
  for (int k = 0; k < n; ++k) {
    held.set_share(k, 1.0);
    eval_rates(effect.col(k).data());
    effect.col(k) = away - effect.col(k);
    held.set_share(k, 0.0);
  }
  const auto add_return = [&] {
    update_arguments(t, y, y + n_free_, target);
    for (int k = 0; k < n; ++k) {
      away[k] += target.loads.breaks[static_cast<std::size_t>(surfaces[k])].argument / (kReturnShare * time_scale);
    }
  };
  const auto solve = [&] { return n == 1 ? Vector(away / effect(0, 0)) : Vector(effect.partialPivLu().solve(away)); };
  add_return();
  Vector shares = solve();
  for (int k = 0; k < n; ++k) held.set_share(k, shares[k]);
  for (int pass = 0; pass < kFrictionPasses && !tables_->friction_joints.empty(); ++pass) {
    eval_rates(away.data());
    add_return();
    shares += solve();
    for (int k = 0; k < n; ++k) held.set_share(k, shares[k]);
  }
  eval_dynamics(*tables_, t, y, y + n_free_, modes, feedback_, target);
}

void MotionEquations::update_arguments(double t, const double* q, const double* v, Workspace& target) noexcept {
  gudgeon::update_coordinates(*tables_, t, q, v, target.coordinates);
  update_point_motions(*tables_, target);
  update_breaks(*tables_, t, target);
}

void MotionEquations::find_argument_rates(double t, const double* y, std::span<const int> breaks, Workspace& target,
                                          double* rates) noexcept {
  const double h = kDifferenceShare * time_scale;
  std::copy_n(target.equations.begin(), n_free_, acceleration_.begin());
  std::fill_n(rates, breaks.size(), 0.0);
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < n_free_; ++i) {
      moved_[i] = y[i] + sign * h * y[n_free_ + i];
      moved_[n_free_ + i] = y[n_free_ + i] + sign * h * acceleration_[i];
    }
    update_arguments(t + sign * h, moved_.data(), moved_.data() + n_free_, target);
    for (std::size_t k = 0; k < breaks.size(); ++k) {
      rates[k] += sign * target.loads.breaks[static_cast<std::size_t>(breaks[k])].argument / (2.0 * h);
    }
  }
}

}  // namespace gudgeon
