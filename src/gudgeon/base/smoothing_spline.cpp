// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cubic B-splines on knots of one spacing, much closer than the cut-off asks for; their coefficients from a banded
// system.
#include "gudgeon/base/smoothing_spline.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gudgeon {

namespace {

// Knots a wave of the cut-off frequency. A cubic spline misses the curvature of a wave by (2π/n)²/12 of it: 1.3 % at
// the cut-off, where half is left of the wave.
constexpr double kKnotsAWave = 16.0;
// Fewer give a periodic curve no four different neighbours.
constexpr int kFewestPieces = 8;
// Halvings of an octave: the cut-off to 1e-4 of its value.
constexpr int kHalvings = 13;

using Weights = std::array<double, 4>;

/// The four B-splines that are not zero in a piece, at u of its length.
Weights eval_basis(double u) {
  const double v = 1.0 - u;
  return {v * v * v / 6.0, (u * u * (3.0 * u - 6.0) + 4.0) / 6.0, (v * v * (3.0 * v - 6.0) + 4.0) / 6.0,
          u * u * u / 6.0};
}

class SmoothingFit {
 public:
  SmoothingFit(const MeasuredPoints& points, double frequency) : points_(points) {
    const double wanted = std::ceil(kKnotsAWave * frequency * points.length());
    n_pieces_ = std::max(kFewestPieces, static_cast<int>(wanted));
    n_unknowns_ = points.periodic ? n_pieces_ : n_pieces_ + 3;
    width_ = points.length() / n_pieces_;
    band_.setZero(n_unknowns_, 4);
    right_.setZero(n_unknowns_);
    add_points();
    // ∫ s‴² over a piece is the square of the third difference of its coefficients over h⁵.
    const double omega = 2.0 * std::numbers::pi * frequency;
    const double penalty = 1.0 / (std::pow(omega, 6) * std::pow(width_, 5));
    for (int k = 0; k < n_pieces_; ++k) add_square(k, {-1.0, 3.0, -3.0, 1.0}, penalty);
    solve();
  }

  [[nodiscard]] Curve make_curve() const {
    std::vector<double> arguments;
    std::vector<double> values;
    std::vector<double> curvatures;
    for (int k = 0; k <= n_pieces_; ++k) {
      const double first = coefficient(k);
      const double second = coefficient(k + 1);
      const double third = coefficient(k + 2);
      arguments.push_back(k == n_pieces_ ? points_.arguments.back() : points_.arguments.front() + k * width_);
      values.push_back((first + 4.0 * second + third) / 6.0);
      curvatures.push_back((first - 2.0 * second + third) / (width_ * width_));
    }
    return {std::move(arguments), values, curvatures, points_.periodic};
  }

 private:
  // The last point of a periodic curve is the first again.
  [[nodiscard]] std::size_t count_points() const { return points_.arguments.size() - (points_.periodic ? 1 : 0); }

  // Half of the way to either neighbour, so that sums over the points are integrals.
  [[nodiscard]] double find_weight(std::size_t i) const {
    const auto& x = points_.arguments;
    const std::size_t last = x.size() - 1;
    const double before = i > 0 ? x[i] - x[i - 1] : points_.periodic ? x[last] - x[last - 1] : 0.0;
    const double after = i < last ? x[i + 1] - x[i] : 0.0;
    return 0.5 * (before + after);
  }

  void add_points() {
    for (std::size_t i = 0; i < count_points(); ++i) {
      const double place = (points_.arguments[i] - points_.arguments.front()) / width_;
      const int piece = std::clamp(static_cast<int>(place), 0, n_pieces_ - 1);
      const Weights basis = eval_basis(place - piece);
      const double weight = find_weight(i);
      add_square(piece, basis, weight);
      for (int k = 0; k < 4; ++k) right_[find_index(piece + k)] += weight * basis[k] * points_.values[i];
    }
  }

  // Adds weight (w · c)² for the four coefficients from that one on.
  void add_square(int from, const Weights& w, double weight) {
    for (int i = 0; i < 4; ++i) {
      for (int k = i; k < 4; ++k) band_(find_index(from + i), k - i) += weight * w[i] * w[k];
    }
  }

  void solve() {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n_unknowns_; ++i) {
      for (int apart = 0; apart < 4; ++apart) {
        const int other = points_.periodic ? (i + apart) % n_unknowns_ : i + apart;
        if (other >= n_unknowns_) continue;
        entries.emplace_back(std::max(i, other), std::min(i, other), band_(i, apart));
      }
    }
    Eigen::SparseMatrix<double> matrix(n_unknowns_, n_unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    coefficients_ = factors.solve(right_);
    // One refinement: parabolas, which the penalty does not hold, come out to rounding.
    const Eigen::VectorXd rest = right_ - matrix.selfadjointView<Eigen::Lower>() * coefficients_;
    coefficients_ += factors.solve(rest);
  }

  [[nodiscard]] int find_index(int k) const { return points_.periodic ? k % n_unknowns_ : k; }
  [[nodiscard]] double coefficient(int k) const { return coefficients_[find_index(k)]; }

  const MeasuredPoints& points_;
  int n_pieces_ = 0;
  int n_unknowns_ = 0;
  double width_ = 0.0;
  Eigen::MatrixXd band_;  // row i: products of coefficient i with itself and the three behind it
  Eigen::VectorXd right_;
  Eigen::VectorXd coefficients_;
};

double find_distance(const MeasuredPoints& points, const Curve& curve) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.arguments.size(); ++i) {
    const double apart = points.values[i] - curve.eval(points.arguments[i]).value;
    sum += apart * apart;
  }
  return std::sqrt(sum / static_cast<double>(points.arguments.size()));
}

}  // namespace

SmoothedCurve smooth_at(const MeasuredPoints& points, double frequency) {
  Curve curve = SmoothingFit(points, frequency).make_curve();
  const double distance = find_distance(points, curve);
  return {std::move(curve), frequency, distance};
}

SmoothedCurve smooth_within(const MeasuredPoints& points, double tolerance) {
  const double highest = points.highest_frequency();
  double too_low = 0.0;
  double frequency = 0.5 / points.length();
  SmoothedCurve best = smooth_at(points, frequency);
  while (best.distance > tolerance && frequency < highest) {
    too_low = frequency;
    frequency = std::min(2.0 * frequency, highest);
    best = smooth_at(points, frequency);
  }
  if (too_low == 0.0 || best.distance > tolerance) return best;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::sqrt(too_low * best.frequency);
    SmoothedCurve tried = smooth_at(points, middle);
    if (tried.distance > tolerance) {
      too_low = middle;
    } else {
      best = std::move(tried);
    }
  }
  return best;
}

}  // namespace gudgeon
