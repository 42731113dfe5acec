// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The second derivatives M_k at the points from a banded linear system; between them each piece is a cubic.
#include "gudgeon/base/cubic_spline.h"

#include <Eigen/SparseLU>
#include <algorithm>
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

}  // namespace

CubicSpline::CubicSpline(std::vector<double> arguments, std::vector<double> values, bool periodic)
    : arguments_(std::move(arguments)),
      values_(std::move(values)),
      curvatures_(find_curvatures(arguments_, values_, periodic)),
      periodic_(periodic) {}

CubicSpline::Value CubicSpline::eval(double argument) const noexcept {
  const double first = arguments_.front();
  const double last = arguments_.back();
  if (periodic_) {
    const double period = last - first;
    argument -= period * std::floor((argument - first) / period);
  } else if (argument < first) {
    return {values_.front(), 0.0, 0.0};
  } else if (argument > last) {
    return {values_.back(), 0.0, 0.0};
  }
  // The piece that holds the argument, the last one at the end.
  const auto above = std::upper_bound(arguments_.begin() + 1, arguments_.end() - 1, argument);
  const auto k = static_cast<std::size_t>(above - arguments_.begin()) - 1;
  const double h = arguments_[k + 1] - arguments_[k];
  const double b = (argument - arguments_[k]) / h;
  const double a = 1.0 - b;
  const double before = curvatures_[k];
  const double after = curvatures_[k + 1];
  return {a * values_[k] + b * values_[k + 1] + (a * (a * a - 1.0) * before + b * (b * b - 1.0) * after) * h * h / 6.0,
          (values_[k + 1] - values_[k]) / h + ((1.0 - 3.0 * a * a) * before + (3.0 * b * b - 1.0) * after) * h / 6.0,
          a * before + b * after};
}

std::pair<double, double> CubicSpline::find_piece(double argument) const noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double first = arguments_.front();
  const double period = arguments_.back() - first;
  const double shift = periodic_ ? period * std::floor((argument - first) / period) : 0.0;
  const auto above = std::upper_bound(arguments_.begin(), arguments_.end(), argument - shift);
  double low = above == arguments_.begin() ? -kInfinity : shift + *(above - 1);
  double high = above == arguments_.end() ? kInfinity : shift + *above;
  // Rounding in the shift may put the argument just beyond the last point.
  if (periodic_ && above == arguments_.begin()) low = shift + first;
  if (periodic_ && above == arguments_.end()) high = shift + period + arguments_[1];
  return {low, high};
}

}  // namespace gudgeon
