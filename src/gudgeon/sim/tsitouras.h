// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The explicit Runge-Kutta pair of Tsitouras, order 5(4), with dense output of order 4.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/sim/dense_step.h"

namespace gudgeon {

/// One step at a time; who decides on its length sees the error estimate first. The last stage of a step is the first
/// of the next. Ch. Tsitouras, Computers & Mathematics with Applications 62 (2011) 770. Allocates nothing after
/// construction.
class Tsitouras final : public DenseStep {
 public:
  static constexpr int kStages = 7;
  /// When, in shares of the step, the stages are taken, and the weights of the fifth-order solution: a quantity that
  /// is integrated along takes the same weights.
  static constexpr std::array<double, kStages> kNodes{0.0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0, 1.0};
  static constexpr std::array<double, kStages> kWeights{
      0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.290069515436081, 2.324710524099774, 0.0};
  /// Weights of a rule of second order, and nearly of third, that are not negative: for what may nowhere become so.
  static constexpr std::array<double, kStages> kShares{0.0, 0.0, 0.5 / 0.673, 0.0, 0.0, 0.0, 0.173 / 0.673};

  /// y is n_states components that its slope depends on, then n_integrals of what is only summed up.
  Tsitouras(std::size_t n_states, std::size_t n_integrals)
      : n_states_(n_states),
        n_(n_states + n_integrals),
        start_(n_),
        end_(n_),
        error_(n_states),
        stage_(n_),
        slopes_(kStages * n_) {}

  void transfer(StateArchive& archive) {
    transfer_times(archive);
    archive(start_, end_, error_, stage_, slopes_);
  }

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
  /// The same of component i, which may be an integral.
  [[nodiscard]] double find_error(std::size_t i) const noexcept { return h_ * sum_slopes<kStages>(kErrorWeights, i); }

  /// h |λ| [1] of the last attempt, λ the fastest rate that its last two stages, which are at one time, feel; beyond
  /// 3.5 decays are not stable. weigh(i, size) is by how much component i counts. Hairer & Wanner 1996, IV.2.
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
    std::array<double, kStages> weights;
    for (int j = 0; j < kStages; ++j) {
      const auto& [constant, linear, square] = kDenseWeights[j];
      weights[j] = share * (1.0 - share) * h_ * (constant + share * (linear + share * square));
    }
    for (std::size_t i = 0; i < n_wanted; ++i) {
      double bend = 0.0;
      for (int j = 0; j < kStages; ++j) bend += weights[j] * slope_of(j)[i];
      y[i] = (1.0 - share) * start_[i] + share * end_[i] + bend;
    }
  }

 private:
  static constexpr std::array<std::array<double, 6>, kStages> kCoefficients{{
      {},
      {0.161},
      {-0.008480655492356989, 0.335480655492357},
      {2.8971530571054935, -6.359448489975075, 4.3622954328695815},
      {5.325864828439257, -11.748883564062828, 7.4955393428898365, -0.09249506636175525},
      {5.86145544294642, -12.92096931784711, 8.159367898576159, -0.071584973281401, -0.028269050394068383},
      {0.09646076681806523, 0.01, 0.4798896504144996, 1.379008574103742, -3.290069515436081, 2.324710524099774},
  }};
  // Weights of the fifth order against those of the fourth.
  static constexpr std::array<double, kStages> kErrorWeights{
      -0.00178001105222577714, -0.0008164344596567469, 0.007880878010261995, -0.1447110071732629,
      0.5823571654525552,      -0.45808210592918697,   0.015151515151515152};
  // d₀, d₁, d₂ of each stage: y(s) = (1 − s) y₀ + s y₁ + s (1 − s) h Σ (d₀ + s d₁ + s² d₂) k.
  static constexpr std::array<std::array<double, 3>, kStages> kDenseWeights{{
      {0.90353923318193474, -1.8601669640928911, 1.0530884977290216},
      {-0.01, 0.1217, -0.1017},
      {-0.4798896504144996, 3.450406586480252, -2.4906272856512528},
      {-1.379008574103742, -13.790085741037419, 16.548102889244902},
      {3.290069515436081, 40.799382931947122, -47.379521962819283},
      {-2.324710524099774, -30.221236813297061, 34.870657861496611},
      {0.0, 1.5, -2.5},
  }};

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
