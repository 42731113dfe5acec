// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The explicit Runge-Kutta pair of Dormand and Prince, order 5(4), with dense output of order 4.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
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

  explicit DormandPrince(std::size_t n)
      : n_(n), start_(n), end_(n), error_(n), stage_(n), slopes_(kStages, std::vector<double>(n)) {}

  /// Sets the start of the next step and its slope.
  void begin(double time, const std::vector<double>& y, const std::vector<double>& slope) {
    time_ = time;
    start_ = y;
    slopes_[0] = slope;
  }

  /// Tries a step of length h. rhs(stage, t, y, dydt) is called for stages 1 to 6; stage 6 is taken at the end.
  template <class Rhs>
  void attempt(double h, Rhs&& rhs) {
    h_ = h;
    for (int s = 1; s < kStages; ++s) {
      const double* a = kCoefficients[s].data();
      for (std::size_t i = 0; i < n_; ++i) {
        double sum = a[0] * slopes_[0][i];
        for (int j = 1; j < s; ++j) sum += a[j] * slopes_[j][i];
        stage_[i] = start_[i] + h * sum;
      }
      if (s == kStages - 1) end_ = stage_;
      rhs(s, time_ + kNodes[s] * h, s == kStages - 1 ? end_.data() : stage_.data(), slopes_[s].data());
    }
    for (std::size_t i = 0; i < n_; ++i) {
      double sum = 0.0;
      for (int j = 0; j < kStages; ++j) sum += kErrorWeights[j] * slopes_[j][i];
      error_[i] = h * sum;
    }
  }

  [[nodiscard]] const std::vector<double>& start() const { return start_; }
  [[nodiscard]] const std::vector<double>& end() const { return end_; }
  [[nodiscard]] const std::vector<double>& end_slope() const { return slopes_[kStages - 1]; }
  /// Estimated local error of each component over the last attempt.
  [[nodiscard]] const std::vector<double>& error() const { return error_; }

  /// h |λ| [1] of the last attempt, λ the fastest rate that its last two stages, which are at one time, feel; beyond
  /// 3.3 decays are not stable. weigh(i, size) is by how much component i counts. Hairer & Wanner 1996, IV.2.
  template <class Weigh>
  [[nodiscard]] double find_stiffness(std::size_t n_counted, Weigh&& weigh) const noexcept {
    double slopes = 0.0;
    double states = 0.0;
    for (std::size_t i = 0; i < n_counted; ++i) {
      double apart = 0.0;
      for (int j = 0; j < kStages - 2; ++j) apart += (kCoefficients[6][j] - kCoefficients[5][j]) * slopes_[j][i];
      apart += kCoefficients[6][5] * slopes_[5][i];
      const double weight = weigh(i, end_[i]);
      states += weight * weight * apart * apart;
      const double slope = weight * (slopes_[6][i] - slopes_[5][i]);
      slopes += slope * slope;
    }
    return states > 0.0 ? std::sqrt(slopes / states) : 0.0;
  }

  /// Within the last attempt.
  void interpolate(double share, std::size_t n_wanted, double* y) const noexcept override {
    const double rest = 1.0 - share;
    for (std::size_t i = 0; i < n_wanted; ++i) {
      const double difference = end_[i] - start_[i];
      const double bump = h_ * slopes_[0][i] - difference;
      const double skew = difference - h_ * slopes_[6][i] - bump;
      double fourth = 0.0;
      for (int j = 0; j < kStages; ++j) fourth += kDenseWeights[j] * slopes_[j][i];
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

  std::size_t n_;
  std::vector<double> start_;
  std::vector<double> end_;
  std::vector<double> error_;
  std::vector<double> stage_;
  std::vector<std::vector<double>> slopes_;
};

}  // namespace gudgeon
