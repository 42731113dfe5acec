// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Least steps, shortened until the gaps shrink.
#include "gudgeon/system/loop_closer.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/system/closure_rank.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/free_gradients.h"
#include "gudgeon/system/least_solution.h"
#include "gudgeon/system/sparse_closures.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Closed is when the largest gap is at rounding of the mechanism's size.
constexpr double kLoopClosedShare = 1e-13;
// Where rounding stops progress just above the aim.
constexpr double kLoopRoundedShare = 100.0 * kLoopClosedShare;
constexpr int kMostClosingSteps = 200;
constexpr double kMostTurnOfStep = 0.5;  // [rad, m] in one step

}  // namespace

LoopCloser::LoopCloser(const Mechanism& mechanism, const Topology& topology, const Tables& tables, double time)
    : workspace(tables),
      q(VectorXd::Zero(tables.counts.n_free())),
      v(VectorXd::Zero(tables.counts.n_free())),
      mechanism_(&mechanism),
      topology_(&topology),
      tables_(&tables),
      time_(time) {
  for (const ClosureTerm& term : tables.closure_terms) size_ = std::max(size_, norm(term.vector));
  for (const ClosureRows& rows : tables.closures) {
    if (rows.kind == ClosureKind::angle) size_ = std::max(size_, 1.0);
  }
  if (size_ == 0.0) size_ = 1.0;
}

void LoopCloser::update() {
  update_coordinates(*tables_, time_, q.data(), v.data(), workspace.coordinates);
  update_closures(*tables_, workspace);
}

StartQuantity LoopCloser::find_quantity(const GivenStart& given) const {
  return gudgeon::find_quantity(*mechanism_, *topology_, given, workspace.coordinates);
}

LoopCloser::Pins LoopCloser::set_pinned(std::span<const GivenStart> pinned) {
  Pins pins{std::vector<bool>(static_cast<std::size_t>(q.size()), false), {}};
  for (const GivenStart& given : pinned) {
    const StartQuantity quantity = find_quantity(given);
    const int coordinate = quantity.find_coordinate();
    if (coordinate < 0) {
      pins.rows.push_back(given);
      continue;
    }
    q(coordinate) += find_way(given, quantity.value);
    pins.frozen[static_cast<std::size_t>(coordinate)] = true;
  }
  update();
  return pins;
}

VectorXd LoopCloser::find_gaps(const Pins& pins) const {
  const VectorXd closures = find_closure_gaps(workspace);
  VectorXd gaps(closures.size() + static_cast<Index>(pins.rows.size()));
  gaps.head(closures.size()) = closures;
  for (std::size_t k = 0; k < pins.rows.size(); ++k) {
    gaps(closures.size() + static_cast<Index>(k)) = -find_way(pins.rows[k], find_quantity(pins.rows[k]).value);
  }
  return gaps;
}

MatrixXd LoopCloser::find_jacobian(const Pins& pins) const {
  const MatrixXd closures = find_closure_jacobian(*tables_, workspace);
  MatrixXd jacobian(closures.rows() + static_cast<Index>(pins.rows.size()), q.size());
  jacobian.topRows(closures.rows()) = closures;
  for (std::size_t k = 0; k < pins.rows.size(); ++k) {
    jacobian.row(closures.rows() + static_cast<Index>(k)) = find_quantity(pins.rows[k]).make_row(q.size());
  }
  for (std::size_t k = 0; k < pins.frozen.size(); ++k) {
    if (pins.frozen[k]) jacobian.col(static_cast<Index>(k)).setZero();
  }
  return jacobian;
}

// The least change that closes the linearised loops.
VectorXd LoopCloser::find_step(const Pins& pins) const {
  if (q.size() <= kMostDenseUnknowns) {
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(kRankThreshold);
    solver.compute(find_jacobian(pins));
    return solver.solve(-find_gaps(pins));
  }
  const Index n_closures = 2 * static_cast<Index>(tables_->closures.size());
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Index row, Index column, double value) {
    if (!pins.frozen[static_cast<std::size_t>(column)]) entries.emplace_back(row, column, value);
  };
  const SparseMatrix closures = find_sparse_jacobian(*tables_, workspace.coordinates);
  for (Index column = 0; column < closures.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(closures, column); entry; ++entry) add(entry.row(), column, entry.value());
  }
  for (std::size_t k = 0; k < pins.rows.size(); ++k) {
    for (const auto& [column, derivative] : find_quantity(pins.rows[k]).gradient) {
      add(n_closures + static_cast<Index>(k), column, derivative);
    }
  }
  SparseMatrix jacobian(n_closures + static_cast<Index>(pins.rows.size()), q.size());
  jacobian.setFromTriplets(entries.begin(), entries.end());
  return find_least_solution(jacobian, -find_gaps(pins));
}

bool LoopCloser::close(std::span<const GivenStart> pinned) {
  update();
  const Pins pins = set_pinned(pinned);
  if (tables_->closures.empty() && pins.rows.empty()) return true;
  double error = find_gaps(pins).norm();
  for (int iteration = 0; iteration < kMostClosingSteps; ++iteration) {
    if (error <= kLoopClosedShare * size_) return true;
    if (q.size() == 0) return error <= kLoopRoundedShare * size_;  // drivers hold everything
    const VectorXd step = find_step(pins);
    const double largest = step.cwiseAbs().maxCoeff();
    double share = largest > kMostTurnOfStep ? kMostTurnOfStep / largest : 1.0;
    const VectorXd start = q;
    bool shrunk = false;
    for (int attempt = 0; attempt < 30 && !shrunk; ++attempt, share *= 0.5) {
      q = start + share * step;
      update();
      shrunk = find_gaps(pins).norm() < error;
    }
    if (!shrunk) {
      q = start;
      update();
      return error <= kLoopRoundedShare * size_;
    }
    error = find_gaps(pins).norm();
  }
  return false;
}

std::vector<GivenStart> LoopCloser::select_free(const std::vector<GivenStart>& given, int* n_free) {
  if (q.size() == 0 || given.empty()) return {};
  update();
  std::vector<Gradient> gradients;
  for (const GivenStart& one : given) gradients.push_back(find_quantity(one).gradient);
  const FreeGradients found = find_free_gradients(find_sparse_jacobian(*tables_, workspace.coordinates), gradients);
  if (n_free != nullptr) *n_free = found.n_free;
  std::vector<GivenStart> free;
  for (const int k : found.free) free.push_back(given[k]);
  return free;
}

}  // namespace gudgeon
