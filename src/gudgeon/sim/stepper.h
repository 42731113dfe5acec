// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How a motion is taken over one step: what the explicit and the stiff integrator have in common.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/sim/dense_step.h"
#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// A step below this [s] means that a run cannot go on: a few roundings of time, or of the longest step.
[[nodiscard]] inline double find_smallest_step(double time, double longest_step) noexcept {
  return 16.0 * std::numeric_limits<double>::epsilon() * std::max(time, longest_step);
}

/// Attempts a step, ends it earlier when asked to, and accepts it. An attempt leaves the workspace's coordinates at its
/// end, an accepted step all of the workspace. Allocates nothing after construction.
class Stepper {
 public:
  Stepper(MotionEquations& equations, SolverStatistics& statistics, int n_stages)
      : equations_(equations),
        statistics_(statistics),
        end_(equations.size()),
        end_slope_(equations.size()),
        samples_(n_stages, std::vector<ContactSample>(equations.contact_modes.size())) {}
  virtual ~Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  /// Where the next step starts. It continues the last one unless the state or the contact modes were changed since.
  virtual void begin(double time, const std::vector<double>& y, const std::vector<double>& slope, bool continues) = 0;
  /// Tries a step, at most `longest` and at most what is `left` [s] to the milestone, which is then hit exactly. False
  /// when it misses its tolerance; the next attempt is shorter.
  virtual bool attempt(double longest, double left) = 0;
  /// Ends the last attempt after h [s] instead.
  virtual void end_at(double h) = 0;
  /// Gives the last attempt up; the next is much shorter.
  virtual void shorten() = 0;
  /// Takes the last attempt as the step: its end, its slope there, its samples.
  virtual void accept() = 0;
  /// Length that the next attempt wants [s].
  [[nodiscard]] virtual double next_step() const = 0;
  /// Wants a step of that length [s] next, whatever the last one suggests.
  virtual void propose(double /*h*/) {}
  /// A contact begins where the next step starts.
  virtual void note_onset() {}
  /// Whether an attempt leaves all of the workspace at its end, not only the coordinates.
  [[nodiscard]] virtual bool evaluates_end() const { return false; }
  /// Whether closures are projected within a step, so that nobody else has to.
  [[nodiscard]] virtual bool projects_closures() const { return false; }
  /// The last attempt or step.
  [[nodiscard]] virtual const DenseStep& dense() const = 0;

  /// When its stages are, in shares of the step.
  [[nodiscard]] virtual std::span<const double> nodes() const = 0;
  /// Weights [1] of the stages in an integral over the step.
  [[nodiscard]] virtual std::span<const double> weights() const = 0;
  /// The same of a rule of at least second order whose weights are not negative.
  [[nodiscard]] virtual std::span<const double> shares() const { return weights(); }
  /// What a contact was like at a stage of the step; without force where it was open.
  [[nodiscard]] const ContactSample& find_sample(int stage, std::size_t contact) const {
    return samples_[stage][contact];
  }
  /// Whether slip changed its direction between stages of the step at which the contact pressed.
  [[nodiscard]] bool turns_slip(std::size_t contact) const noexcept {
    double least = 0.0;
    double most = 0.0;
    for (const auto& stage : samples_) {
      if (!(stage[contact].normal_force > 0.0)) continue;
      least = std::min(least, stage[contact].slip_speed);
      most = std::max(most, stage[contact].slip_speed);
    }
    return least < 0.0 && most > 0.0;
  }
  /// Goes on where another stepper's last step ended.
  void take_over_end(const Stepper& other) { take_over(other.samples_.back()); }
  /// Starts again where another stepper's last attempt, which was given up, had started.
  void take_over_start(const Stepper& other) { take_over(other.samples_.front()); }
  /// A contact has ended.
  void forget_samples(std::size_t contact) {
    for (auto& stage : samples_) stage[contact] = {};
  }

  /// Whether its next attempt depends on nothing but what transfer() saves.
  [[nodiscard]] virtual bool can_be_saved() const { return true; }
  /// Whether what transfer() saves tells the inside of the last step, too.
  [[nodiscard]] virtual bool saves_dense_step() const { return true; }
  virtual void transfer(StateArchive& archive) { archive(end_, end_slope_, samples_); }

  [[nodiscard]] const std::vector<double>& end() const { return end_; }
  [[nodiscard]] const std::vector<double>& end_slope() const { return end_slope_; }

 protected:
  // The workspace was evaluated at this stage.
  void take_samples(int stage) noexcept {
    for (std::size_t k = 0; k < equations_.contact_modes.size(); ++k) {
      if (equations_.contact_modes[k].in_contact) samples_[stage][k] = equations_.find_sample(k);
    }
  }
  // The end of the last step is the start of the next.
  void pass_samples_on() noexcept {
    for (std::size_t k = 0; k < equations_.contact_modes.size(); ++k) {
      if (equations_.contact_modes[k].in_contact) samples_.front()[k] = samples_.back()[k];
    }
  }

  MotionEquations& equations_;
  SolverStatistics& statistics_;
  std::vector<double> end_;
  std::vector<double> end_slope_;

 private:
  // The next step begins with the samples of the last stage.
  void take_over(const std::vector<ContactSample>& samples) {
    for (auto& stage : samples_) stage = samples;
  }

  std::vector<std::vector<ContactSample>> samples_;  // samples_[stage][contact]
};

}  // namespace gudgeon
