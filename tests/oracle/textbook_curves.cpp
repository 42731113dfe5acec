// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hermite's cubics and Simpson's rule, which is exact for them.
#include "tests/oracle/textbook_curves.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gudgeon::oracle {

TextbookCurve::TextbookCurve(const SampledCurve& curve, Interpolation interpolation)
    : x_(curve.arguments), y_(curve.values), slopes_(x_.size()), periodic_(curve.periodic) {
  linear_ = interpolation == Interpolation::linear;
  if (interpolation == Interpolation::spline) find_spline_slopes();
  if (interpolation == Interpolation::monotone) find_monotone_slopes();
}

// Unknown are the slopes m. The curvature at the end of one cubic is that at the begin of the next,
// m₋/h + 2 m (1/h + 1/g) + m₊/g = 3 (s/h + t/g) with the chords' widths h, g and slopes s, t; at the second and the
// last but one point of a curve with ends so is the third derivative, (m₋ + m − 2 s)/h² = (m + m₊ − 2 t)/g².
void TextbookCurve::find_spline_slopes() {
  const auto n = static_cast<Eigen::Index>(x_.size());
  if (n < 4) throw std::runtime_error("oracle: a spline through fewer than four points");
  const auto width = [&](Eigen::Index k) {
    return x_[static_cast<std::size_t>(k + 1)] - x_[static_cast<std::size_t>(k)];
  };
  const auto chord = [&](Eigen::Index k) {
    return (y_[static_cast<std::size_t>(k + 1)] - y_[static_cast<std::size_t>(k)]) / width(k);
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const auto add_smooth = [&](Eigen::Index row, Eigen::Index before, Eigen::Index at, Eigen::Index after) {
    const double h = width(before);
    const double g = width(at);
    matrix(row, before) += 1.0 / h;
    matrix(row, at) += 2.0 / h + 2.0 / g;
    matrix(row, after) += 1.0 / g;
    right(row) = 3.0 * (chord(before) / h + chord(at) / g);
  };
  for (Eigen::Index k = 1; k + 1 < n; ++k) add_smooth(k, k - 1, k, k + 1);
  if (periodic_) {
    add_smooth(0, n - 2, 0, 1);
    matrix(n - 1, 0) = 1.0;
    matrix(n - 1, n - 1) = -1.0;
  } else {
    const auto add_end = [&](Eigen::Index row, Eigen::Index k) {
      const double h = width(k - 1);
      const double g = width(k);
      matrix(row, k - 1) += 1.0 / (h * h);
      matrix(row, k) += 1.0 / (h * h) - 1.0 / (g * g);
      matrix(row, k + 1) -= 1.0 / (g * g);
      right(row) = 2.0 * (chord(k - 1) / (h * h) - chord(k) / (g * g));
    };
    add_end(0, 1);
    add_end(n - 1, n - 2);
  }
  const Eigen::VectorXd slopes = matrix.fullPivLu().solve(right);
  slopes_.assign(slopes.begin(), slopes.end());
}

// At a turn the slope is zero; elsewhere it is a harmonic mean of the chords' on either side, weighted for their
// widths. At the ends it is that of the outermost chord.
void TextbookCurve::find_monotone_slopes() {
  const std::size_t n = x_.size();
  const auto mean = [](double h, double s, double g, double t) {
    if (s * t <= 0.0) return 0.0;
    const double first = 2.0 * g + h;
    const double second = g + 2.0 * h;
    return (first + second) / (first / s + second / t);
  };
  const auto width = [&](std::size_t k) { return x_[k + 1] - x_[k]; };
  const auto chord = [&](std::size_t k) { return (y_[k + 1] - y_[k]) / width(k); };
  for (std::size_t k = 1; k + 1 < n; ++k) slopes_[k] = mean(width(k - 1), chord(k - 1), width(k), chord(k));
  slopes_[0] = periodic_ ? mean(width(n - 2), chord(n - 2), width(0), chord(0)) : chord(0);
  slopes_[n - 1] = periodic_ ? slopes_[0] : chord(n - 2);
}

TextbookValue TextbookCurve::eval(double argument) const {
  if (periodic_) {
    const double period = x_.back() - x_.front();
    argument -= period * std::floor((argument - x_.front()) / period);
  }
  if (argument < x_.front()) return {y_.front(), 0.0, 0.0};
  if (argument > x_.back()) return {y_.back(), 0.0, 0.0};
  std::size_t k = 0;
  while (k + 2 < x_.size() && argument >= x_[k + 1]) ++k;
  const double h = x_[k + 1] - x_[k];
  const double chord = (y_[k + 1] - y_[k]) / h;
  const double s = argument - x_[k];
  if (linear_) return {y_[k] + chord * s, chord, 0.0};
  const double second = (3.0 * chord - 2.0 * slopes_[k] - slopes_[k + 1]) / h;
  const double third = (slopes_[k] + slopes_[k + 1] - 2.0 * chord) / (h * h);
  return {y_[k] + s * (slopes_[k] + s * (second + s * third)), slopes_[k] + s * (2.0 * second + 3.0 * s * third),
          2.0 * second + 6.0 * s * third};
}

double TextbookCurve::integrate(double from, double to) const {
  return integrate_from_first(to) - integrate_from_first(from);
}

double TextbookCurve::integrate_from_first(double to) const {
  double sum = 0.0;
  double periods = 0.0;
  if (periodic_) {
    const double period = x_.back() - x_.front();
    periods = std::floor((to - x_.front()) / period);
    to -= periods * period;
  }
  if (to < x_.front()) return y_.front() * (to - x_.front());
  double whole = 0.0;
  for (std::size_t k = 0; k + 1 < x_.size(); ++k) {
    const auto simpson = [&](double end) {
      const double h = end - x_[k];
      // Values just inside the piece: at its ends they are the points'.
      const double middle = eval(x_[k] + 0.5 * h).value;
      const double last = end == x_[k + 1] ? y_[k + 1] : eval(end).value;
      return h / 6.0 * (y_[k] + 4.0 * middle + last);
    };
    const double piece = simpson(x_[k + 1]);
    whole += piece;
    if (to >= x_[k + 1]) {
      sum += piece;
    } else if (to > x_[k]) {
      sum += simpson(to);
    }
  }
  if (to > x_.back()) sum += y_.back() * (to - x_.back());
  return sum + periods * whole;
}

TextbookCurve TextbookCurve::of_load(const SampledCurve& curve) {
  return {curve, curve.interpolation.value_or(Interpolation::monotone)};
}

TextbookCurve TextbookCurve::of_motion(const SampledCurve& curve) { return {curve, Interpolation::spline}; }

}  // namespace gudgeon::oracle
