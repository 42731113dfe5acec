// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The explicit Runge-Kutta pair of Dormand and Prince, order 5(4), with dense output of order 4.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "gudgeon/sim/dense_step.h"

namespace gudgeon {

/// One step at a time; who decides on its length sees the error estimate first. The last stage of a step is the first
/// of the next. Dormand & Prince 1980; dense output of Hairer, Nørsett & Wanner 1993, II.6. Allocates nothing after
/// construction.
class DormandPrince final : public DenseStep {
 public:
  static constexpr int kStages = 7;
  /// When, in shares of the step, the stages are taken, and the weights of the fifth-order solution: a quantity that
  /// is integrated along takes the same weights.
  static constexpr std::array<double, kStages> kNodes{0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
  static constexpr std::array<double, kStages> kWeights{35.0 / 384,     0.0,       500.0 / 1113, 125.0 / 192,
                                                        -2187.0 / 6784, 11.0 / 84, 0.0};

  /// y is n_states components that its slope depends on, then n_integrals of what is only summed up.
  DormandPrince(std::size_t n_states, std::size_t n_integrals)
      : n_states_(n_states),
        n_(n_states + n_integrals),
        start_(n_),
        end_(n_),
        error_(n_states),
        stage_(n_),
        slopes_(kStages * n_) {}

  /// Sets the start of the next step and its slope.
  void begin(double time, const std::vector<double>& y, const std::vector<double>& slope) {
    time_ = time;
    start_ = y;
    std::ranges::copy(slope, slopes_.begin());
  }

  /// Tries a step of length h. rhs(stage, t, y, dydt) is called for stages 1 to 6, stage 6 at the end, with all states
  /// but no integrals in y.
  template <class Rhs>
  void attempt(double h, Rhs&& rhs) {
    h_ = h;
    [&]<int... kBefore>(std::integer_sequence<int, kBefore...>) { (eval_stage<kBefore + 1>(rhs), ...); }
    (std::make_integer_sequence<int, kStages - 1>{});
    for (std::size_t i = n_states_; i < n_; ++i) end_[i] = start_[i] + h * sum_slopes<kStages>(kWeights, i);
    for (std::size_t i = 0; i < n_states_; ++i) error_[i] = h * sum_slopes<kStages>(kErrorWeights, i);
  }

  [[nodiscard]] const std::vector<double>& start() const { return start_; }
  [[nodiscard]] const std::vector<double>& end() const { return end_; }
  [[nodiscard]] std::span<const double> end_slope() const { return {slope_of(kStages - 1), n_}; }
  /// Estimated local error of each state over the last attempt.
  [[nodiscard]] const std::vector<double>& error() const { return error_; }

  /// h |λ| [1] of the last attempt, λ the fastest rate that its last two stages, which are at one time, feel; beyond
  /// 3.3 decays are not stable. weigh(i, size) is by how much component i counts. Hairer & Wanner 1996, IV.2.
  template <class Weigh>
  [[nodiscard]] double find_stiffness(std::size_t n_counted, Weigh&& weigh) const noexcept {
    double slopes = 0.0;
    double states = 0.0;
    for (std::size_t i = 0; i < n_counted; ++i) {
      double apart = 0.0;
      for (int j = 0; j < kStages - 2; ++j) apart += (kCoefficients[6][j] - kCoefficients[5][j]) * slope_of(j)[i];
      apart += kCoefficients[6][5] * slope_of(5)[i];
      const double weight = weigh(i, end_[i]);
      states += weight * weight * apart * apart;
      const double slope = weight * (slope_of(6)[i] - slope_of(5)[i]);
      slopes += slope * slope;
    }
    return states > 0.0 ? std::sqrt(slopes / states) : 0.0;
  }

  /// Within the last attempt.
  void interpolate(double share, std::size_t n_wanted, double* y) const noexcept override {
    const double rest = 1.0 - share;
    for (std::size_t i = 0; i < n_wanted; ++i) {
      const double difference = end_[i] - start_[i];
      const double bump = h_ * slope_of(0)[i] - difference;
      const double skew = difference - h_ * slope_of(kStages - 1)[i] - bump;
      const double fourth = sum_slopes<kStages>(kDenseWeights, i);
      y[i] = start_[i] + share * (difference + rest * (bump + share * (skew + rest * h_ * fourth)));
    }
  }

 private:
  static constexpr std::array<std::array<double, 6>, kStages> kCoefficients{{
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
  }};
  // Fifth- minus fourth-order weights.
  static constexpr std::array<double, kStages> kErrorWeights{71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                                             -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
  static constexpr std::array<double, kStages> kDenseWeights{
      -12715105075.0 / 11282082432.0,  0.0,
      87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
      701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
      69997945.0 / 29380423.0};

  [[nodiscard]] const double* slope_of(int stage) const {
    return slopes_.data() + static_cast<std::size_t>(stage) * n_;
  }

  // Σ w_j k_j of component i over the first stages, in their order. Weights are known while compiling, so that zeros
  // cost nothing.
  template <int kCount, std::size_t kSize>
  [[nodiscard]] double sum_slopes(const std::array<double, kSize>& weights, std::size_t i) const noexcept {
    const double* slope = slopes_.data() + i;
    double sum = weights[0] * slope[0];
    for (int j = 1; j < kCount; ++j) {
      if (weights[j] != 0.0) sum += weights[j] * slope[static_cast<std::size_t>(j) * n_];
    }
    return sum;
  }

  template <int kStage, class Rhs>
  void eval_stage(Rhs& rhs) {
    double* y = kStage == kStages - 1 ? end_.data() : stage_.data();
    for (std::size_t i = 0; i < n_states_; ++i) {
      y[i] = start_[i] + h_ * sum_slopes<kStage>(kCoefficients[kStage], i);
    }
    rhs(kStage, time_ + kNodes[kStage] * h_, y, slopes_.data() + static_cast<std::size_t>(kStage) * n_);
  }

  std::size_t n_states_;
  std::size_t n_;
  std::vector<double> start_;
  std::vector<double> end_;
  std::vector<double> error_;
  std::vector<double> stage_;
  std::vector<double> slopes_;  // stage after stage
};

}  // namespace gudgeon
