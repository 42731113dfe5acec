// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// CVODE's steps, and the integrals along them.
#include "gudgeon/sim/stiff_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gudgeon {

namespace {

constexpr int kStages = StiffStepper::kStages;
constexpr double kRootOfFive = 2.23606797749978969;
// Lobatto's nodes and weights on [0, 1].
constexpr std::array<double, kStages> kNodes{0.0, 0.5 - 0.5 / kRootOfFive, 0.5 + 0.5 / kRootOfFive, 1.0};
constexpr std::array<double, kStages> kWeights{1.0 / 12, 5.0 / 12, 5.0 / 12, 1.0 / 12};
// The explicit pair goes on with the better of its two solutions and so stays far below its tolerance; errors of
// backward differentiation are as large as they are estimated, and add up. With this share both come equally near the
// truth.
constexpr double kErrorShare = 0.02;
// A step that has to be given up is tried again as this share of it.
constexpr double kShortened = 0.2;
// The slope is compared with that a little later to find the first step: a share of the longest step, then the guess.
constexpr double kFirstLook = 1e-6;
constexpr int kLooks = 2;
// CVODE takes no steps of less than a hundred roundings of time; these are so many of the smallest.
constexpr double kShortest = 16.0;

// ∫₀ˢ of the cubic that is one at one node and zero at the others: coefficients of s, s², s³, s⁴.
using Integral = std::array<double, kStages>;
constexpr std::array<Integral, kStages> kIntegrals = [] {
  std::array<Integral, kStages> all{};
  for (int j = 0; j < kStages; ++j) {
    std::array<double, kStages> cubic{1.0};
    int degree = 0;
    for (int m = 0; m < kStages; ++m) {
      if (m == j) continue;
      const double scale = 1.0 / (kNodes[j] - kNodes[m]);
      ++degree;
      for (int p = degree; p >= 0; --p) cubic[p] = scale * ((p > 0 ? cubic[p - 1] : 0.0) - kNodes[m] * cubic[p]);
    }
    for (int p = 0; p < kStages; ++p) all[j][p] = cubic[p] / (p + 1);
  }
  return all;
}();

double eval_integral(int stage, double share) {
  const Integral& c = kIntegrals[stage];
  return share * (c[0] + share * (c[1] + share * (c[2] + share * c[3])));
}

}  // namespace

StiffStepper::StiffStepper(MotionEquations& equations, SolverStatistics& statistics, const ErrorTolerance& tolerance,
                           ClosureProjection* projection, double longest_step)
    : Stepper(equations, statistics, kStages),
      tolerance_(tolerance),
      projection_(projection),
      cvode_(*this, equations.n_states(), projection != nullptr, find_smallest_step(0.0, longest_step), longest_step),
      start_(equations.size()),
      start_slope_(equations.size()),
      state_(equations.size()),
      slope_(equations.size()),
      longest_step_(longest_step),
      next_(longest_step) {}

std::span<const double> StiffStepper::nodes() const { return kNodes; }

std::span<const double> StiffStepper::weights() const { return kWeights; }

bool StiffStepper::eval(double t, const double* y, double* slope) noexcept {
  ++statistics_.evaluations;
  equations_.eval(t, y, slope_.data());
  double sum = 0.0;
  for (std::size_t i = 0; i < equations_.n_states(); ++i) {
    slope[i] = slope_[i];
    sum += 0.0 * slope_[i];
  }
  return std::isfinite(sum);
}

void StiffStepper::find_weights(const double* y, double* weights) noexcept {
  for (std::size_t i = 0; i < equations_.n_states(); ++i) {
    weights[i] = 1.0 / (kErrorShare * tolerance_.find(i, std::abs(y[i])));
  }
}

bool StiffStepper::find_correction(double t, const double* y, double* correction) noexcept {
  const std::size_t n = equations_.n_states();
  equations_.update_coordinates(t, y);
  if (!projection_->is_needed(equations_.workspace)) {
    std::fill_n(correction, n, 0.0);
    return true;
  }
  std::copy_n(y, n, state_.begin());
  ++statistics_.evaluations;
  equations_.eval(t, state_.data(), slope_.data());
  const int n_corrections = projection_->project(t, state_, slope_, equations_);
  statistics_.projections += n_corrections;
  statistics_.evaluations += n_corrections;
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    correction[i] = state_[i] - y[i];
    sum += 0.0 * correction[i];
  }
  return std::isfinite(sum);
}

// The first step is of order 1, so that its error is ½ h² |ÿ|; a quarter of the tolerance is aimed at. CVODE's own
// guess takes the time in which a component leaves its tolerance for its time scale: next to nothing for a straight
// bristle.
double StiffStepper::find_first_step() {
  const std::size_t n = equations_.n_states();
  double h = kFirstLook * longest_step_;
  for (int look = 0; look < kLooks; ++look) {
    for (std::size_t i = 0; i < n; ++i) state_[i] = start_[i] + h * start_slope_[i];
    ++statistics_.evaluations;
    equations_.eval(time_ + h, state_.data(), slope_.data());
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double ratio = (slope_[i] - start_slope_[i]) / (h * kErrorShare * tolerance_.find(i, std::abs(start_[i])));
      sum += ratio * ratio;
    }
    const double guess = std::sqrt(0.5 / std::sqrt(sum / static_cast<double>(std::max<std::size_t>(n, 1))));
    h = std::isfinite(guess) ? std::clamp(guess, find_smallest_step(time_, longest_step_), longest_step_)
                             : kFirstLook * longest_step_;
  }
  return h;
}

void StiffStepper::restart(double first_step) {
  cvode_.restart(time_, start_.data(), first_step);
  n_failures_ = 0;
  n_steps_ = 0;
  restarts_ = false;
  is_fresh_ = true;
}

void StiffStepper::begin(double time, const std::vector<double>& y, const std::vector<double>& slope, bool continues) {
  time_ = time;
  start_ = y;
  start_slope_ = slope;
  std::copy_n(slope.begin() + static_cast<std::ptrdiff_t>(equations_.n_states()), kEnergyIntegrals,
              powers_.front().begin());
  pass_samples_on();
  restarts_ = restarts_ || !continues;
}

bool StiffStepper::attempt(double /*longest*/, double left) {
  is_line_ = left <= kShortest * find_smallest_step(time_, longest_step_);
  if (is_line_) {
    restarts_ = true;
    h_ = whole_ = left;
  } else {
    if (restarts_) restart(find_first_step());
    const std::optional<double> reached = cvode_.step(time_ + left);
    const long n_failures = cvode_.count_failures();
    statistics_.rejected_steps += n_failures - n_failures_;
    n_failures_ = n_failures;
    if (!reached) {
      // A history may be at fault; without one nothing more can be done.
      next_ = is_fresh_ ? 0.0 : std::numeric_limits<double>::infinity();
      restarts_ = true;
      return false;
    }
    is_fresh_ = false;
    h_ = whole_ = *reached - time_;
  }
  move_to_end();
  return true;
}

// Dense output is off the constraints by its error. The end is put onto them, lest the next step move the gap there.
void StiffStepper::end_at(double h) {
  h_ = h;
  restarts_ = h != whole_;
  move_to_end();
  if (projection_ == nullptr || !restarts_) return;
  ++statistics_.evaluations;
  equations_.eval(time_ + h_, end_.data(), slope_.data());
  const int n_corrections = projection_->close(time_ + h_, end_, slope_, equations_);
  statistics_.projections += n_corrections;
  statistics_.evaluations += n_corrections;
}

void StiffStepper::move_to_end() {
  interpolate(1.0, equations_.n_states(), end_.data());
  equations_.update_coordinates(time_ + h_, end_.data());
}

void StiffStepper::shorten() {
  next_ = kShortened * whole_;
  restart(next_);
}

void StiffStepper::take_stage(int stage) {
  const double t = time_ + kNodes[stage] * h_;
  ++statistics_.evaluations;
  equations_.eval(t, state_.data(), end_slope_.data());
  std::copy_n(end_slope_.begin() + static_cast<std::ptrdiff_t>(equations_.n_states()), kEnergyIntegrals,
              powers_[stage].begin());
  take_samples(stage);
}

void StiffStepper::accept() {
  for (int stage = 1; stage < kStages - 1; ++stage) {
    interpolate(kNodes[stage], equations_.n_states(), state_.data());
    take_stage(stage);
  }
  std::copy_n(end_.begin(), equations_.n_states(), state_.begin());
  take_stage(kStages - 1);
  add_integrals(1.0, end_.size(), end_.data());
  restarts_ = restarts_ || ++n_steps_ >= kLongestHistory;
}

void StiffStepper::transfer(StateArchive& archive) {
  Stepper::transfer(archive);
  transfer_times(archive);
  archive(start_, start_slope_, state_, slope_, powers_, restarts_, is_fresh_, is_line_, whole_, next_);
  archive(n_failures_, n_steps_);
}

void StiffStepper::interpolate(double share, std::size_t n_wanted, double* y) const noexcept {
  const std::size_t n = equations_.n_states();
  if (is_line_) {
    for (std::size_t i = 0; i < std::min(n, n_wanted); ++i) y[i] = start_[i] + share * h_ * start_slope_[i];
  } else {
    cvode_.interpolate(time_ + share * h_, n_wanted, y);
  }
  add_integrals(share, n_wanted, y);
}

void StiffStepper::add_integrals(double share, std::size_t n_wanted, double* y) const noexcept {
  const std::size_t n = equations_.n_states();
  for (std::size_t i = n; i < n_wanted; ++i) {
    double integral = 0.0;
    for (int stage = 0; stage < kStages; ++stage) integral += eval_integral(stage, share) * powers_[stage][i - n];
    y[i] = start_[i] + h_ * integral;
  }
}

}  // namespace gudgeon
