// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Guesses, the iteration of a stage, dense output.
#include "gudgeon/sim/implicit_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace gudgeon {

namespace {

constexpr int kStages = Esdirk::kStages;
// A stage is solved once a correction is below this share of the tolerance; the last one is still made. The energy
// balance may hold a step to a tenth of its tolerance, and powers are those before the last correction.
constexpr double kSolved = 0.001;
// Of tolerances next to rounding, corrections below this share that no longer shrink are all that can be had.
constexpr double kNearlySolved = 0.1;
constexpr double kStalled = 0.5;
// Contact forces alone are left to the corrections, so they shrink fast or not at all.
constexpr int kMostCorrections = 8;

// Which stages the accelerations of one are guessed from, by a polynomial through them: those of the last step count
// from -2. Near the stage in time, and far enough from each other.
constexpr std::array<std::array<int, 4>, kStages> kGuessedFrom{
    {{}, {-2, -1, 0}, {-1, 0, 1}, {-1, 0, 1, 2}, {0, 3, 1, 2}, {3, 1, 2, 4}, {1, 2, 4, 5}}};
constexpr std::array<int, kStages> kGuesses{0, 3, 3, 4, 4, 4, 4};
constexpr std::array<int, 2> kPastStages{4, 5};

}  // namespace

ImplicitStepper::ImplicitStepper(MotionEquations& equations, SolverStatistics& statistics,
                                 const ErrorTolerance& tolerance, double first_step)
    : ControlledStepper(equations, statistics, tolerance, kStages, first_step),
      tolerance_(tolerance),
      response_(equations.tables()),
      n_free_(equations.n_free()),
      start_(equations.size()),
      error_(2 * n_free_),
      base_(2 * n_free_),
      acceleration_(n_free_),
      residual_(n_free_),
      slope_(equations.size()) {
  for (auto& slope : slopes_) slope.resize(equations.size());
  for (auto& past : past_) past.resize(n_free_);
}

void ImplicitStepper::begin(double time, const std::vector<double>& y, const std::vector<double>& slope,
                            bool continues) {
  time_ = time;
  start_ = y;
  slopes_.front() = slope;
  pass_samples_on();
  has_past_ = has_past_ && continues;
  if (!has_response_ || !continues) {
    ++statistics_.evaluations;
    equations_.eval(time, y.data(), slope_.data());
    response_.update(equations_.workspace);
    has_response_ = true;
  }
  begin_energy_control(y, continues);
}

void ImplicitStepper::end_at(double h) {
  h_ = h;
  for (int stage = 1; stage < kStages; ++stage) {
    if (solve_stage(stage)) continue;
    std::ranges::fill(end_, std::numeric_limits<double>::quiet_NaN());
    equations_.eval(time_ + h, end_.data(), slope_.data());  // whoever looks at the workspace must see that, too
    return;
  }
  for (std::size_t i = 0; i < error_.size(); ++i) error_[i] = find_error(i);
  for (std::size_t i = error_.size(); i < end_.size(); ++i) {
    double sum = 0.0;
    for (int j = 0; j < kStages; ++j) sum += Esdirk::kWeights[j] * slopes_[j][i];
    end_[i] = start_[i] + h * sum;
  }
}

double ImplicitStepper::find_error(std::size_t component) const {
  double sum = 0.0;
  for (int j = 0; j < kStages; ++j) sum += Esdirk::kErrorWeights[j] * slopes_[j][component];
  return h_ * sum;
}

// Newton's method with the contacts' part of the Jacobian, which most often serves for two corrections. A stage's slope
// has the last correction in it; the end of the step is what was evaluated, so that its slope belongs to it.
bool ImplicitStepper::solve_stage(int stage) noexcept {
  const std::size_t n = n_free_;
  const double tau = Esdirk::kDiagonal * h_;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    double sum = 0.0;
    for (int j = 0; j < stage; ++j) sum += Esdirk::kCoefficients[stage][j] * slopes_[j][i];
    base_[i] = start_[i] + h_ * sum;
  }
  guess_accelerations(stage);
  std::vector<double>& slope = slopes_[stage];
  double last_size = std::numeric_limits<double>::infinity();
  for (int correction = 0; correction < kMostCorrections; ++correction) {
    for (std::size_t i = 0; i < n; ++i) {
      end_[n + i] = base_[n + i] + tau * acceleration_[i];
      end_[i] = base_[i] + tau * end_[n + i];
    }
    ++statistics_.evaluations;
    equations_.eval(time_ + Esdirk::kNodes[stage] * h_, end_.data(), slope.data());
    response_.weigh(tau, equations_.contact_modes, equations_.workspace);
    for (std::size_t i = 0; i < n; ++i) residual_[i] = slope[n + i] - acceleration_[i];
    response_.correct(residual_.data());
    const double size = find_size(tau);
    if (!std::isfinite(size)) return false;
    for (std::size_t i = 0; i < n; ++i) acceleration_[i] += residual_[i];
    const bool is_rounding = size < kNearlySolved && size > kStalled * last_size;
    last_size = size;
    if (size > kSolved && !is_rounding) continue;
    take_samples(stage);
    if (stage == kStages - 1) std::ranges::copy(slope, end_slope_.begin());
    for (std::size_t i = 0; i < n; ++i) {
      slope[i] = base_[n + i] + tau * acceleration_[i];
      slope[n + i] = acceleration_[i];
    }
    return true;
  }
  return false;
}

// What a correction changes in the rates, against their tolerances: root mean square.
double ImplicitStepper::find_size(double tau) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < n_free_; ++i) {
    const double ratio = tau * residual_[i] / tolerance_.find(n_free_ + i, std::abs(end_[n_free_ + i]));
    sum += ratio * ratio;
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(n_free_, 1)));
}

void ImplicitStepper::guess_accelerations(int stage) noexcept {
  struct KnownStage {
    double time;
    const double* acceleration;
  };
  std::array<KnownStage, 4> points{};
  std::size_t n_points = 0;
  for (int k = 0; k < kGuesses[stage]; ++k) {
    const int from = kGuessedFrom[stage][k];
    if (from >= 0) {
      points[n_points++] = {Esdirk::kNodes[from] * h_, slopes_[from].data() + n_free_};
    } else if (has_past_) {
      points[n_points++] = {past_times_[kPast + from], past_[kPast + from].data()};
    }
  }
  std::ranges::fill(acceleration_, 0.0);
  const double time = Esdirk::kNodes[stage] * h_;
  for (std::size_t k = 0; k < n_points; ++k) {
    double weight = 1.0;
    for (std::size_t m = 0; m < n_points; ++m) {
      if (m != k) weight *= (time - points[m].time) / (points[k].time - points[m].time);
    }
    for (std::size_t i = 0; i < n_free_; ++i) acceleration_[i] += weight * points[k].acceleration[i];
  }
}

void ImplicitStepper::accept() {
  note_accepted(h_);
  response_.update(equations_.workspace);
  for (int k = 0; k < kPast; ++k) {
    const int stage = kPastStages[k];
    past_times_[k] = (Esdirk::kNodes[stage] - 1.0) * h_;
    std::copy_n(slopes_[stage].begin() + static_cast<std::ptrdiff_t>(n_free_), n_free_, past_[k].begin());
  }
  has_past_ = true;
}

// Coordinates by Hermite's quintic through values, rates and accelerations at both ends; rates and integrals by his
// cubic through values and slopes.
void ImplicitStepper::interpolate(double share, std::size_t n_wanted, double* y) const noexcept {
  const double s = share;
  const double r = 1.0 - share;
  const std::size_t n = n_free_;
  for (std::size_t i = 0; i < n_wanted; ++i) {
    const double rise = end_[i] - start_[i];
    const double leave = h_ * slopes_.front()[i] - rise;
    const double arrive = rise - h_ * end_slope_[i];
    y[i] = start_[i] + s * (rise + r * (leave * r + arrive * s));
    if (i >= n) continue;
    const double bend = 0.5 * h_ * h_ * slopes_.front()[n + i] + 2.0 * leave - arrive;
    const double end_bend = 0.5 * h_ * h_ * end_slope_[n + i] + 2.0 * arrive - leave;
    y[i] += s * s * r * r * (bend * r + end_bend * s);
  }
}

}  // namespace gudgeon
