// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hermite's polynomials.
#include "gudgeon/sim/step_history.h"

#include <algorithm>

namespace gudgeon {

StepHistory::StepHistory(const MotionEquations& equations)
    : n_free_(equations.n_free()), n_wanted_(equations.n_states()) {
  for (Entry& entry : entries_) {
    entry.y.resize(n_wanted_);
    entry.slope.resize(n_wanted_);
    entry.contact_modes = equations.contact_modes;
  }
}

void StepHistory::note(double time, const std::vector<double>& y, const std::vector<double>& slope,
                       const std::vector<ContactMode>& contact_modes) {
  newest_ = (newest_ + 1) % kStates;
  n_states_ = std::min(n_states_ + 1, kStates);
  Entry& entry = entries_[newest_];
  entry.time = time;
  std::copy_n(y.begin(), n_wanted_, entry.y.begin());
  std::copy_n(slope.begin(), n_wanted_, entry.slope.begin());
  std::ranges::copy(contact_modes, entry.contact_modes.begin());
}

const std::vector<ContactMode>& StepHistory::find_contact_modes(double time) const {
  return at(find_end(time)).contact_modes;
}

void StepHistory::interpolate(double time, double* y) const noexcept {
  const int end_age = find_end(time);
  const Entry& a = at(end_age + 1);
  const Entry& b = at(end_age);
  const double h = b.time - a.time;
  const double s = h > 0.0 ? std::clamp((time - a.time) / h, 0.0, 1.0) : 1.0;
  const double r = 1.0 - s;
  // Weights of the cubic in values and slopes, and of the quintic in values, rates and accelerations.
  const double value = s * s * (3.0 - 2.0 * s);
  const double slope_a = h * s * r * r;
  const double slope_b = -h * s * s * r;
  const double far = s * s * s * (10.0 - s * (15.0 - 6.0 * s));
  const double rate_a = h * s * r * r * r * (1.0 + 3.0 * s);
  const double rate_b = -h * r * s * s * s * (1.0 + 3.0 * r);
  const double bend_a = 0.5 * h * h * s * s * r * r * r;
  const double bend_b = 0.5 * h * h * s * s * s * r * r;
  for (std::size_t i = 0; i < n_free_; ++i) {
    y[i] = a.y[i] + far * (b.y[i] - a.y[i]) + rate_a * a.slope[i] + rate_b * b.slope[i] +
           bend_a * a.slope[n_free_ + i] + bend_b * b.slope[n_free_ + i];
  }
  for (std::size_t i = n_free_; i < n_wanted_; ++i) {
    y[i] = a.y[i] + value * (b.y[i] - a.y[i]) + slope_a * a.slope[i] + slope_b * b.slope[i];
  }
}

}  // namespace gudgeon
