// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Steppers that start from the state alone: each step by a Runge-Kutta pair, its length by the pair's error estimate.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/sim/energy_error_control.h"
#include "gudgeon/sim/step_control.h"
#include "gudgeon/sim/stepper.h"
#include "gudgeon/sim/work_control.h"

namespace gudgeon {

/// What is left to a formula is to take a step and to tell of it.
class ControlledStepper : public Stepper {
 public:
  ControlledStepper(MotionEquations& equations, SolverStatistics& statistics, const ErrorTolerance& tolerance,
                    int n_stages, double first_step)
      : Stepper(equations, statistics, n_stages),
        control_(tolerance, first_step),
        shortest_for_works_(kShortestForWorks * first_step) {}

  /// Has the works of loads and drivers keep these tolerances, too.
  void control_works(double relative, double absolute) { works_.emplace(relative, absolute); }

  bool attempt(double longest, double left) final {
    double h = std::min(control_.next_step(), longest);
    if (h >= left * (1.0 - 1e-12)) h = left;  // no sliver of a step before a milestone
    attempted_ = h;
    end_at(h);
    AttemptedStep step = describe_attempt();
    end_residual_ = equations_.find_residual(step.end.data());
    step.energy_error = energy_control_.find_error(end_residual_, find_exchanged(step.end));
    if (step.energy_error > 1.0) step.loss_error = find_loss_error(step);
    if (works_ && h > shortest_for_works_) step.work_error = find_work_error(step);
    return control_.accepts(step);
  }
  void shorten() final { control_.shorten(attempted_); }
  [[nodiscard]] double next_step() const final { return control_.next_step(); }
  void note_onset() final { control_.note_onset(); }
  void propose(double h) final { control_.propose(h); }
  [[nodiscard]] bool evaluates_end() const final { return true; }
  void transfer(StateArchive& archive) override {
    Stepper::transfer(archive);
    archive(control_, energy_control_, largest_load_, attempted_, end_residual_, was_whole_);
  }

 protected:
  /// The last attempt; an error that is not finite where it failed.
  [[nodiscard]] virtual AttemptedStep describe_attempt() const = 0;
  /// Estimated local error of any component, also of an integral, over the last attempt.
  [[nodiscard]] virtual double find_error(std::size_t component) const = 0;
  /// The workspace was evaluated at the start of the next step.
  void begin_energy_control(const std::vector<double>& y, bool continues) noexcept {
    const bool is_known = continues && was_whole_ && y == end_;
    energy_control_.begin(is_known ? end_residual_ : equations_.find_residual(y.data()), find_exchanged(y));
  }
  // A step that was ended early, where a contact changes, says nothing of how long others may be.
  void note_accepted(double h) {
    was_whole_ = h == attempted_;
    if (was_whole_) control_.note_step(h);
  }

 private:
  // Works do not ask for steps shorter than this share of the first one: what sets in from nothing has no size that it
  // could be measured by.
  static constexpr double kShortestForWorks = 1e-4;

  [[nodiscard]] double find_exchanged(std::span<const double> y) const noexcept {
    return y[equations_.n_states() + kExchanged];
  }

  // A contact that opens faster than its force falls gives its energy away without pressing: steps as long as the
  // motion permits would not see how.
  [[nodiscard]] double find_loss_error(const AttemptedStep& step) const noexcept {
    double sum = 0.0;
    for (const int loss : {kContactDamping, kSurfaceWork}) {
      sum += std::abs(find_error(equations_.n_states() + static_cast<std::size_t>(loss)));
    }
    const double kinetic = find_kinetic_energy(equations_.tables(), equations_.workspace.coordinates);
    return energy_control_.find_share(sum, find_exchanged(step.end), kinetic);
  }

  [[nodiscard]] double find_work_error(const AttemptedStep& step) noexcept {
    const std::size_t first = equations_.n_states();
    const bool is_driven = equations_.n_free() == 0;
    double largest = 0.0;
    for (const int work : {kLoadWork, kDamperLoss, kDriverWork, kContactDamping, kFrictionLoss}) {
      // Impacts are in the drivers' efforts, and in the energy balance; it does not see them where all is driven.
      const bool is_of_contacts = work == kContactDamping || work == kFrictionLoss ||
                                  (work == kDriverWork && !equations_.contact_modes.empty());
      if (is_of_contacts && !is_driven) continue;
      largest = std::max(largest, std::abs(find_error(first + static_cast<std::size_t>(work))));
    }
    return works_->find_error(largest, find_exchanged(step.start), find_exchanged(step.end), find_largest_load());
  }

  // [N, N m] that any attempt has ended with
  double find_largest_load() noexcept {
    for (const LoadEffect& effect : equations_.workspace.loads.effects) {
      for (const double size : {effect.force.x, effect.force.y, effect.torque}) {
        if (std::isfinite(size)) largest_load_ = std::max(largest_load_, std::abs(size));
      }
    }
    return largest_load_;
  }

  StepControl control_;
  EnergyErrorControl energy_control_;
  std::optional<WorkControl> works_;
  double shortest_for_works_;  // [s] of the steps that works may ask for
  double largest_load_ = 0.0;  // [N, N m]
  double attempted_ = 0.0;     // [s]
  double end_residual_ = 0.0;  // [J] of the energy balance at the end of the attempt
  bool was_whole_ = false;     // the last step was as long as it was attempted
};

}  // namespace gudgeon
