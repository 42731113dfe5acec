// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Splines: the second derivatives M_k at the points from a banded linear system. Monotone curves: the slopes at the
// points are those of Fritsch and Butland, which Boost.Math chooses.
#include "gudgeon/base/curve.h"

#include <math.h>  // ::isnan, which pchip.hpp of Boost 1.74 uses without including or naming it

#include <Eigen/SparseLU>
#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <limits>

namespace gudgeon {

namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// The slope is continuous at a point between widths h and g: h M₋ + 2 (h + g) M + g M₊ = 6 (slope₊ − slope₋).
void add_smoothness(Entries& entries, int row, int before, int at, int after, double h, double g) {
  entries.emplace_back(row, before, h);
  entries.emplace_back(row, at, 2.0 * (h + g));
  entries.emplace_back(row, after, g);
}

/// The third derivative is continuous at the point between widths h and g: (M − M₋)/h = (M₊ − M)/g.
void add_no_knot(Entries& entries, int row, int before, double h, double g) {
  entries.emplace_back(row, before, g);
  entries.emplace_back(row, before + 1, -(h + g));
  entries.emplace_back(row, before + 2, h);
}

std::vector<double> solve(int n, const Entries& entries, const Eigen::VectorXd& right) {
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());  // equal places add up: two points repeat periodically
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  const Eigen::VectorXd solution = factors.solve(right);
  return {solution.begin(), solution.end()};
}

std::vector<double> find_curvatures(const std::vector<double>& x, const std::vector<double>& y, bool periodic) {
  const int n = static_cast<int>(x.size());
  const auto width = [&](int k) { return x[k + 1] - x[k]; };
  const auto slope = [&](int k) { return (y[k + 1] - y[k]) / width(k); };
  if (n < 3) return std::vector<double>(x.size(), 0.0);
  if (n == 3 && !periodic) return std::vector<double>(3, 2.0 * (slope(1) - slope(0)) / (x[2] - x[0]));
  Entries entries;
  const int n_unknowns = periodic ? n - 1 : n;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n_unknowns);
  for (int k = periodic ? 0 : 1; k < n - 1; ++k) {
    const int before = k > 0 ? k - 1 : n - 2;
    add_smoothness(entries, k, before, k, (k + 1) % n_unknowns, width(before), width(k));
    right[k] = 6.0 * (slope(k) - slope(before));
  }
  if (!periodic) {
    add_no_knot(entries, 0, 0, width(0), width(1));
    add_no_knot(entries, n - 1, n - 3, width(n - 3), width(n - 2));
  }
  std::vector<double> curvatures = solve(n_unknowns, entries, right);
  if (periodic) curvatures.push_back(curvatures.front());
  return curvatures;
}

// Slopes at the points. One more point before the first and one behind the last, of the neighbouring periods or in line
// with the two at the end, give every point its neighbours; an end's slope is then that of its outermost chord.
std::vector<double> find_monotone_slopes(const std::vector<double>& x, const std::vector<double>& y, bool periodic) {
  const std::size_t n = x.size();
  const double period = x[n - 1] - x[0];
  std::vector<double> arguments{periodic ? x[n - 2] - period : 2.0 * x[0] - x[1]};
  std::vector<double> values{periodic ? y[n - 2] : 2.0 * y[0] - y[1]};
  arguments.insert(arguments.end(), x.begin(), x.end());
  values.insert(values.end(), y.begin(), y.end());
  arguments.push_back(periodic ? x[1] + period : 2.0 * x[n - 1] - x[n - 2]);
  values.push_back(periodic ? y[1] : 2.0 * y[n - 1] - y[n - 2]);
  const boost::math::interpolators::pchip<std::vector<double>> curve(std::move(arguments), std::move(values));
  std::vector<double> slopes(n);
  std::ranges::transform(x, slopes.begin(), [&](double argument) { return curve.prime(argument); });
  return slopes;
}

}  // namespace

Curve::Curve(std::vector<double> arguments, const std::vector<double>& values, bool periodic,
             Interpolation interpolation)
    : arguments_(std::move(arguments)), periodic_(periodic), interpolation_(interpolation) {
  std::vector<double> shape;
  if (interpolation == Interpolation::spline) shape = find_curvatures(arguments_, values, periodic);
  if (interpolation == Interpolation::monotone) shape = find_monotone_slopes(arguments_, values, periodic);
  add_cubics(values, shape);
}

Curve::Curve(std::vector<double> arguments, const std::vector<double>& values, const std::vector<double>& curvatures,
             bool periodic)
    : arguments_(std::move(arguments)), periodic_(periodic), interpolation_(Interpolation::spline) {
  add_cubics(values, curvatures);
}

// The shape holds curvatures at the points of a spline, slopes at those of a monotone curve.
void Curve::add_cubics(const std::vector<double>& values, const std::vector<double>& shape) {
  for (std::size_t k = 0; k + 1 < arguments_.size(); ++k) {
    const double h = arguments_[k + 1] - arguments_[k];
    const double rise = values[k + 1] - values[k];
    Cubic cubic{values[k], values[k + 1], 0.0, 0.0};
    if (interpolation_ == Interpolation::spline) {
      cubic.departure = -h * h / 6.0 * (2.0 * shape[k] + shape[k + 1]);
      cubic.arrival = h * h / 6.0 * (shape[k] + 2.0 * shape[k + 1]);
    } else if (interpolation_ == Interpolation::monotone) {
      cubic.departure = h * shape[k] - rise;
      cubic.arrival = h * shape[k + 1] - rise;
    }
    cubics_.push_back(cubic);
  }
}

Curve::Value Curve::eval(double argument) const noexcept {
  const double first = arguments_.front();
  const double last = arguments_.back();
  if (periodic_) {
    argument -= period() * std::floor((argument - first) / period());
  } else if (argument < first) {
    return {cubics_.front().first, 0.0, 0.0};
  } else if (argument > last) {
    return {cubics_.back().last, 0.0, 0.0};
  }
  // The piece that holds the argument, the last one at the end.
  const auto above = std::upper_bound(arguments_.begin() + 1, arguments_.end() - 1, argument);
  const auto k = static_cast<std::size_t>(above - arguments_.begin()) - 1;
  const Cubic& cubic = cubics_[k];
  const double h = arguments_[k + 1] - arguments_[k];
  const double b = (argument - arguments_[k]) / h;
  const double a = 1.0 - b;
  const double p = cubic.departure;
  const double q = cubic.arrival;
  return {a * cubic.first + b * cubic.last + a * b * (a * p - b * q),
          (cubic.last - cubic.first + a * (a - 2.0 * b) * p + b * (b - 2.0 * a) * q) / h,
          ((2.0 * b - 4.0 * a) * p + (4.0 * b - 2.0 * a) * q) / (h * h)};
}

std::pair<double, double> Curve::find_piece(double argument) const noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double first = arguments_.front();
  const double shift = periodic_ ? period() * std::floor((argument - first) / period()) : 0.0;
  const auto above = std::upper_bound(arguments_.begin(), arguments_.end(), argument - shift);
  double low = above == arguments_.begin() ? -kInfinity : shift + *(above - 1);
  double high = above == arguments_.end() ? kInfinity : shift + *above;
  // Rounding in the shift may put the argument just beyond the last point.
  if (periodic_ && above == arguments_.begin()) low = shift + first;
  if (periodic_ && above == arguments_.end()) high = shift + period() + arguments_[1];
  return {low, high};
}

}  // namespace gudgeon
