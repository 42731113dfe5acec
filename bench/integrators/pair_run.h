// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Any equations by the engine's own Runge-Kutta pair and step control, contact changes located on dense output.
#pragma once

#include "bench/integrators/event_search.h"
#include "gudgeon/sim/step_control.h"
#include "gudgeon/sim/tsitouras.h"

namespace gudgeon::bench {

template <class Equations>
class PairRun {
 public:
  PairRun(Equations& equations, const Study& study, double longest_step)
      : equations_(equations),
        longest_(longest_step),
        tolerance_(study, 0, equations.n_states()),
        formula_(equations.n_states(), equations.size() - equations.n_states()),
        control_(tolerance_, 1e-3 * longest_step),
        events_(equations),
        y_(equations.size()),
        slope_(equations.size()) {}

  void begin(const std::vector<double>& y) {
    time_ = 0.0;
    y_ = y;
    eval(time_, y_.data(), slope_.data());
    events_.begin(time_, y_.data());
  }

  /// False when the step gets too short.
  bool advance_to(double end) {
    while (time_ < end) {
      if (!take_step(end)) return false;
    }
    return true;
  }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const std::vector<double>& y() const { return y_; }
  [[nodiscard]] long evaluations() const { return evaluations_; }

 private:
  static constexpr double kShortest = 1e-13;  // [s]

  void eval(double t, const double* y, double* slope) {
    equations_.eval(t, y, slope);
    ++evaluations_;
  }

  void attempt(double h) {
    formula_.attempt(h, [this](int /*stage*/, double t, const double* y, double* slope) { eval(t, y, slope); });
  }

  bool take_step(double end) {
    formula_.begin(time_, y_, slope_);
    double h = 0.0;
    for (;;) {
      h = std::min({control_.next_step(), longest_, end - time_});
      if (h < kShortest && h < end - time_) return false;
      attempt(h);
      if (control_.accepts({formula_.step(), formula_.start(), formula_.end(), formula_.error()})) break;
    }
    const auto look = [this](double t, double* y) {
      formula_.interpolate((t - formula_.start_time()) / formula_.step(), equations_.n_states(), y);
    };
    const auto change = events_.find_first(time_, time_ + h, formula_.end().data(), look);
    if (change) {
      h = std::max(change->time - time_, kShortest);
      attempt(h);
      events_.find_first(time_, time_ + h, formula_.end().data(), look);  // the gaps at the new end
    }
    control_.note_step(h);
    time_ = end - time_ - h <= 0.0 ? end : time_ + h;
    y_ = formula_.end();
    std::ranges::copy(formula_.end_slope(), slope_.begin());
    events_.accept();
    if (change) turn(change->contact);
    return true;
  }

  void turn(std::size_t contact) {
    events_.turn(contact);
    if (equations_.contact_modes[contact].in_contact) control_.note_onset();
    eval(time_, y_.data(), slope_.data());
  }

  Equations& equations_;
  double longest_;
  ErrorTolerance tolerance_;
  Tsitouras formula_;
  StepControl control_;
  EventSearch<Equations> events_;
  double time_ = 0.0;
  std::vector<double> y_;
  std::vector<double> slope_;
  long evaluations_ = 0;
};

}  // namespace gudgeon::bench
