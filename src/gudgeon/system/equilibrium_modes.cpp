// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Eigenvalues λ of the linearised motion ÿ = −K y − C ẏ: frequency |Im λ|/2π, damping ratio −Re λ/|λ|
// (docs/theory/kinematics.md, Eq. K7).
#include "gudgeon/system/equilibrium_modes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Fourth-order differences: truncation h⁴ = 1e-16 and rounding 1e-16/h are both far below what is told apart here.
constexpr double kModeStep = 1e-4;
// Differences leave 1e-11 of the stiffness. Directions with less than this share of the largest one, or than this
// [1/s^2], are neutral, whatever damps them.
constexpr double kNeutral = 1e-10;
// Differences leave 1e-11 of the damping, too: a neutral direction with less than this share of the largest one, or
// than this [1/s], drifts on by itself.
constexpr double kFreeDrift = 1e-9;
// Of an undamped motion the growing and the decaying eigenvalue are opposite but for this share: the root of the 1e-11
// that differences leave, and some more.
constexpr double kOpposite = 1e-5;
// Damping is known to some 1e-10 of the eigenvalue.
constexpr double kUndamped = 1e-7;

/// The derivative of eval(step) at zero.
template <class Eval>
VectorXd find_slope(const Eval& eval) {
  const VectorXd near = eval(kModeStep) - eval(-kModeStep);
  const VectorXd far = eval(2.0 * kModeStep) - eval(-2.0 * kModeStep);
  return (8.0 * near - far) / (12.0 * kModeStep);
}

/// [0 1; −K −C]
MatrixXd find_state_matrix(MotionChart& chart) {
  const Index n = chart.size();
  MatrixXd matrix = MatrixXd::Zero(2 * n, 2 * n);
  matrix.topRightCorner(n, n).setIdentity();
  const VectorXd rest = VectorXd::Zero(n);
  for (Index k = 0; k < n; ++k) {
    const VectorXd unit = VectorXd::Unit(n, k);
    matrix.bottomLeftCorner(n, n).col(k) = find_slope([&](double step) -> VectorXd {
      chart.move_to(step * unit);
      return chart.find_acceleration(rest);
    });
    chart.move_to(rest);
    matrix.bottomRightCorner(n, n).col(k) =
        find_slope([&](double step) -> VectorXd { return chart.find_acceleration(step * unit); });
  }
  chart.move_to(rest);
  chart.find_acceleration(rest);
  return matrix;
}

// How many eigenvalues are zero, and how many directions nothing brings back.
struct NeutralCount {
  Index n_eigenvalues = 0;
  Index n_directions = 0;
};

// K v = 0 gives one eigenvalue zero, and another one where nothing damps v either.
NeutralCount count_neutral(const MatrixXd& state_matrix) {
  const Index n = state_matrix.rows() / 2;
  const MatrixXd stiffness = state_matrix.bottomLeftCorner(n, n);
  const MatrixXd damping = state_matrix.bottomRightCorner(n, n);
  const Eigen::JacobiSVD<MatrixXd> split(stiffness, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double least = kNeutral * std::max(1.0, stiffness.cwiseAbs().maxCoeff());
  const Index n_directions = (split.singularValues().array() <= least).count();
  if (n_directions == 0) return {};
  const MatrixXd left =
      split.matrixU().rightCols(n_directions).transpose() * damping * split.matrixV().rightCols(n_directions);
  const double slowest = kFreeDrift * std::max(1.0, damping.cwiseAbs().maxCoeff());
  const Eigen::JacobiSVD<MatrixXd> drift(left);
  return {n_directions + (drift.singularValues().array() <= slowest).count(), n_directions};
}

EquilibriumMode make_mode(std::complex<double> eigenvalue, bool is_neutral) {
  EquilibriumMode mode;
  if (is_neutral) {
    mode.kind = EquilibriumMode::Kind::neutral;
    return mode;
  }
  const double size = std::abs(eigenvalue);
  mode.growth_rate = std::abs(eigenvalue.real()) <= kUndamped * size ? 0.0 : eigenvalue.real();
  mode.damping_ratio = mode.growth_rate == 0.0 ? 0.0 : -mode.growth_rate / size;
  mode.frequency = std::abs(eigenvalue.imag()) / (2.0 * std::numbers::pi);
  if (mode.growth_rate > 0.0) mode.kind = EquilibriumMode::Kind::unstable;
  return mode;
}

}  // namespace

std::vector<EquilibriumMode> find_modes(const System& system, MotionChart& chart) {
  std::vector<EquilibriumMode> modes;
  const Index n = chart.size();
  if (n == 0) return modes;
  const MatrixXd state_matrix = find_state_matrix(chart);
  const Eigen::EigenSolver<MatrixXd> solver(state_matrix);
  const auto& eigenvalues = solver.eigenvalues();
  const NeutralCount neutral = count_neutral(state_matrix);
  std::vector<Index> slowest_first(2 * n);
  std::iota(slowest_first.begin(), slowest_first.end(), 0);
  std::ranges::stable_sort(slowest_first, {}, [&](Index k) { return std::abs(eigenvalues[k]); });
  for (Index at = 0; at < 2 * n; ++at) {
    const Index k = slowest_first[at];
    const std::complex<double> eigenvalue = eigenvalues[k];
    const bool is_neutral = at < neutral.n_eigenvalues;
    // Of a conjugate pair the upper one, a neutral one for each direction, of ±λ the growing one.
    if (is_neutral && at >= neutral.n_directions) continue;
    if (!is_neutral && eigenvalue.imag() < 0.0) continue;
    const double mirrored = (eigenvalues.array() + eigenvalue).abs().minCoeff();
    if (!is_neutral && eigenvalue.imag() == 0.0 && eigenvalue.real() < 0.0 &&
        mirrored <= kOpposite * std::abs(eigenvalue))
      continue;
    EquilibriumMode mode = make_mode(eigenvalue, is_neutral);
    const VectorXd shape = (chart.basis() * solver.eigenvectors().col(k).head(n)).cwiseAbs();
    Index most = 0;
    shape.maxCoeff(&most);
    mode.most_moved = name_coordinate(system, most);
    modes.push_back(std::move(mode));
  }
  std::ranges::stable_sort(modes, [](const EquilibriumMode& a, const EquilibriumMode& b) {
    const bool first = a.kind == EquilibriumMode::Kind::unstable;
    const bool second = b.kind == EquilibriumMode::Kind::unstable;
    return first != second ? first : a.frequency < b.frequency;
  });
  return modes;
}

bool Equilibrium::is_stable() const {
  return std::ranges::all_of(modes, [](const auto& mode) { return mode.kind == EquilibriumMode::Kind::stable; });
}

}  // namespace gudgeon
