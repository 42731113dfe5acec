// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Any equations by CVODE's backward differentiation with a dense Jacobian of differences, restarted at each contact
// change, as one would use it from a textbook.
#pragma once

#include <cmath>

#include "bench/integrators/event_search.h"
#include "gudgeon/model/study.h"
#include "gudgeon/sim/cvode.h"

namespace gudgeon::bench {

template <class Equations>
class BdfRun final : private StiffProblem {
 public:
  BdfRun(Equations& equations, const Study& study, double longest_step)
      : equations_(equations),
        absolute_(study.absolute_tolerance),
        relative_(study.relative_tolerance),
        cvode_(*this, equations.size(), false, kShortest, longest_step),
        events_(equations),
        y_(equations.size()) {}

  void begin(const std::vector<double>& y) {
    time_ = 0.0;
    y_ = y;
    cvode_.restart(time_, y_.data());
    events_.begin(time_, y_.data());
  }

  /// False when CVODE gives up.
  bool advance_to(double end) {
    while (time_ < end) {
      const std::optional<double> reached = cvode_.step(end);
      if (!reached) return false;
      const auto look = [this](double t, double* y) { cvode_.interpolate(t, y_.size(), y); };
      look(*reached, y_.data());
      auto change = events_.find_first(time_, *reached, y_.data(), look);
      if (change) {
        change->time = std::max(change->time, time_ + kShortest);
        look(change->time, y_.data());
        events_.find_first(time_, change->time, y_.data(), look);  // the gaps at the new end
      }
      time_ = change ? change->time : *reached;
      events_.accept();
      if (change) {
        events_.turn(change->contact);
        cvode_.restart(time_, y_.data());
      }
    }
    return true;
  }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const std::vector<double>& y() const { return y_; }
  [[nodiscard]] long evaluations() const { return evaluations_; }

 private:
  static constexpr double kShortest = 1e-14;  // [s]

  bool eval(double t, const double* y, double* slope) noexcept override {
    ++evaluations_;
    equations_.eval(t, y, slope);
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      if (!std::isfinite(slope[i])) return false;
    }
    return true;
  }
  // The work integral is carried along without a tolerance of its own.
  void find_weights(const double* y, double* weights) noexcept override {
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      weights[i] = i < equations_.n_states() ? 1.0 / (absolute_ + relative_ * std::abs(y[i])) : 1e-6;
    }
  }
  bool find_correction(double /*t*/, const double* /*y*/, double* /*correction*/) noexcept override { return false; }

  Equations& equations_;
  double absolute_;
  double relative_;
  Cvode cvode_;
  EventSearch<Equations> events_;
  double time_ = 0.0;
  std::vector<double> y_;
  long evaluations_ = 0;
};

}  // namespace gudgeon::bench
