// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Contact changes for the comparators: when, within a step, a gap closes or a contact opens.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "bench/textbook/maximal_form.h"

namespace gudgeon::bench {

using textbook::GapSample;

/// Regula falsi with halving (Illinois) of a continuous f with a sign change in [a, b].
template <class Function>
double find_root(Function&& f, double a, double b, double fa, double fb) {
  constexpr int kMostPasses = 60;
  for (int pass = 0; pass < kMostPasses && std::abs(b - a) > 1e-15 * std::abs(b); ++pass) {
    const double c = b - fb * (b - a) / (fb - fa);
    const double fc = f(c);
    if (fc == 0.0) return c;
    if ((fc > 0.0) == (fb > 0.0)) {
      fa *= 0.5;
    } else {
      a = b, fa = fb;
    }
    b = c, fb = fc;
  }
  return b;
}

/// Watches the gaps of equations over steps.
template <class Equations>
class EventSearch {
 public:
  struct Change {
    std::size_t contact;
    double time;  ///< [s]
  };

  explicit EventSearch(Equations& equations)
      : equations_(equations),
        start_(equations.contact_modes.size()),
        end_(start_),
        looked_(start_),
        y_(equations.size()) {}

  void begin(double t, const double* y) { equations_.find_gaps(t, y, start_); }

  /// The first change in the step; interpolate(time, y) gives states inside it.
  template <class Interpolate>
  std::optional<Change> find_first(double t0, double t1, const double* y_end, Interpolate&& interpolate) {
    equations_.find_gaps(t1, y_end, end_);
    std::optional<Change> first;
    for (std::size_t k = 0; k < start_.size(); ++k) {
      const auto time = find_change(k, t0, t1, interpolate);
      if (time && (!first || *time < first->time)) first = Change{k, *time};
    }
    return first;
  }
  /// The step ended as it was looked at.
  void accept() { std::swap(start_, end_); }

  /// Switches the mode of a contact whose change the last step ended at.
  void turn(std::size_t k) {
    ContactMode& mode = equations_.contact_modes[k];
    mode = mode.in_contact ? ContactMode{} : ContactMode{true, start_[k].penetration_rate};
  }

 private:
  // With the sign turned in contact, both changes are a rise of s δ through zero, at first from a hair above or below.
  template <class Interpolate>
  std::optional<double> find_change(std::size_t k, double t0, double t1, Interpolate&& interpolate) {
    const double sign = equations_.contact_modes[k].in_contact ? -1.0 : 1.0;
    const auto value = [&](double t) { return sign * look(k, t, interpolate).penetration; };
    const auto rate = [&](double t) { return sign * look(k, t, interpolate).penetration_rate; };
    const double rate_start = sign * start_[k].penetration_rate;
    const double rate_end = sign * end_[k].penetration_rate;
    double bottom = t0;
    double value_bottom = sign * start_[k].penetration;
    double top = t1;
    double value_top = sign * end_[k].penetration;
    if (rate_start > 0.0 && rate_end < 0.0 && value_top <= 0.0) {  // up and down again
      top = find_root(rate, t0, t1, rate_start, rate_end);
      value_top = value(top);
    } else if (rate_start < 0.0 && rate_end > 0.0) {  // down and up again
      bottom = find_root(rate, t0, t1, rate_start, rate_end);
      value_bottom = value(bottom);
    }
    if (value_top <= 0.0) return std::nullopt;
    if (value_bottom >= 0.0) {
      if (rate_end <= 0.0) return std::nullopt;  // still leaving what it has just left
      return bottom > t0 ? bottom : t1;
    }
    return find_root(value, bottom, top, value_bottom, value_top);
  }

  template <class Interpolate>
  GapSample look(std::size_t k, double t, Interpolate&& interpolate) {
    interpolate(t, y_.data());
    equations_.find_gaps(t, y_.data(), looked_);
    return looked_[k];
  }

  Equations& equations_;
  std::vector<GapSample> start_;
  std::vector<GapSample> end_;
  std::vector<GapSample> looked_;
  std::vector<double> y_;
};

}  // namespace gudgeon::bench
