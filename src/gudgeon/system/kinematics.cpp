// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Taylor's prediction, Gauss-Newton on the closures, and a watch on the sign of their determinant:
// q + q̇ h + ½ q̈ h²,  then q ← q − J⁺ φ(q, t),  J q̇ = −∂φ/∂t (docs/theory/kinematics.md, Eq. K1)
#include "gudgeon/system/kinematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/closure_rank.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/load_forces.h"
#include "gudgeon/system/mobility.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Closed is when the largest gap is at rounding of the mechanism's size.
constexpr double kFollowedShare = 1e-13;
// From a good prediction Gauss-Newton needs three or four iterations.
constexpr int kMostCorrections = 12;
// A correction [rad, shares of the size] beyond this means that the prediction was too far; branches of a loop are much
// further apart but near a singular position, where the determinant's sign tells them from each other.
constexpr double kLargestCorrection = 0.05;
// Loops close to 1e-13 of the size. Where a loop is flat its fold shows in them as a square, so that an angle is known
// to the root of that, 3e-7: below this reciprocal condition of the closures one branch cannot be told from the other.
constexpr double kSingularShare = 1e-6;
// Velocities that differ by more than this share of the largest one from what the accelerations foretell have a kink
// between them, as where a step passes from one branch to another, or the step is too long to tell.
constexpr double kKink = 0.05;
// How far [rad, shares of the size] beyond the last point a failure is asked for its reason: there the branches that
// met are apart again by far more than they are known to, and loops out of reach stay open by far more than rounding.
constexpr double kLookBeyond = 1e-2;
// Steps end at this share of the way that is left or of the time: a singular position is then located to rounding.
constexpr double kLeastStep = 1e-13;

Mechanism require_driven(const Mechanism& mechanism) {
  Mechanism ideal = make_ideal(mechanism);
  const int n_left = find_mobility(ideal).n_degrees_of_freedom;
  if (n_left <= 0) return ideal;
  Diagnostics diagnostics;
  diagnostics.error(
      "E-MODEL-079", "drivers",
      fmt::format("{} degree{} of freedom {} left; kinematics needs drivers that prescribe all of the motion", n_left,
                  n_left == 1 ? "" : "s", n_left == 1 ? "is" : "are"),
      {fmt::format("add {} driver{} ([drivers.NAME] with body or slide, and speed), or find the motion under "
                   "loads with `gudgeon run`",
                   n_left, n_left == 1 ? "" : "s")});
  throw ModelError(diagnostics);
}

System compile_driven(const Mechanism& mechanism) {
  const Mechanism ideal = require_driven(mechanism);
  return compile(ideal, assemble(ideal));
}

// The enforced rows, lengths measured in shares of a size [m].
MatrixXd select_active_rows(const Tables& tables, const MatrixXd& jacobian, double size) {
  MatrixXd active(tables.n_rows, jacobian.cols());
  Index next = 0;
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    const double unit = tables.closures[c].kind == ClosureKind::angle ? 1.0 : size;
    for (int k = 0; k < 2; ++k) {
      if (tables.closures[c].active[k]) active.row(next++) = jacobian.row(static_cast<Index>(2 * c) + k) / unit;
    }
  }
  active.rightCols(tables.counts.n_free_slides) *= size;
  return active;
}

double find_longest_vector(const Tables& tables) {
  double longest = 0.0;
  for (const ClosureTerm& term : tables.closure_terms) longest = std::max(longest, norm(term.vector));
  return longest > 0.0 ? longest : 1.0;  // without any, angles alone are closed
}

}  // namespace

KinematicSolver::KinematicSolver(const Mechanism& mechanism)
    : system_(compile_driven(mechanism)),
      folds_(system_.topology, system_.tables),
      workspace_(system_.tables),
      size_(find_longest_vector(system_.tables)) {
  if (has_free_rows(system_.tables)) row_choice_.emplace(system_);
  next_.q = make_state(system_, assemble(system_.mechanism)).q;
  next_.v.assign(next_.q.size(), 0.0);
  next_.a.assign(next_.q.size(), 0.0);
  point_ = next_;
  update(0.0);
  if (!find_motion()) {
    fail(MotionFailure::Kind::singular);
    return;
  }
  orientation_ = find_orientation();
  point_ = next_;
}

void KinematicSolver::update(double time) {
  next_.time = time;
  update_coordinates(system_.tables, time, next_.q.data(), next_.v.data(), workspace_.coordinates);
  update_closures(system_.tables, workspace_);
}

// Moves next_ onto the closures; false when they do not close from here.
bool KinematicSolver::close_loops() {
  const Tables& tables = system_.tables;
  if (tables.closures.empty()) return true;
  Eigen::Map<VectorXd> q(next_.q.data(), static_cast<Index>(next_.q.size()));
  double least = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kMostCorrections; ++iteration) {
    const VectorXd gaps = find_closure_gaps(workspace_);
    const double error = gaps.norm();
    if (!std::isfinite(error)) return false;
    if (error <= kFollowedShare * size_ && error >= 0.5 * least) return true;  // one more iteration gained nothing
    if (error >= least) return error <= 100.0 * kFollowedShare * size_;
    least = error;
    if (error == 0.0) return true;
    if (q.size() == 0) break;  // drivers hold everything
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(kRankThreshold);
    solver.compute(find_closure_jacobian(tables, workspace_));
    q -= solver.solve(gaps);
    update(next_.time);
  }
  return least <= 100.0 * kFollowedShare * size_;
}

// Velocities and accelerations of next_; false at a singular position.
bool KinematicSolver::find_motion() {
  const Tables& tables = system_.tables;
  std::ranges::fill(next_.v, 0.0);
  update(next_.time);
  if (find_orientation() == 0.0) return false;
  if (!tables.closures.empty() && !next_.v.empty()) {
    const MatrixXd jacobian = find_closure_jacobian(tables, workspace_);
    Eigen::Map<VectorXd>(next_.v.data(), static_cast<Index>(next_.v.size())) =
        Eigen::CompleteOrthogonalDecomposition<MatrixXd>(jacobian).solve(-find_closure_rates(workspace_));
  }
  eval_dynamics(tables, next_.time, next_.q.data(), next_.v.data(), {}, {}, workspace_);
  std::copy_n(workspace_.equations.begin(), next_.a.size(), next_.a.begin());
  return find_lost_load(workspace_) < 0 && std::ranges::all_of(next_.a, [](double a) { return std::isfinite(a); });
}

// The sign of the determinant of the enforced closures, lengths measured against the mechanism's size; zero where they
// do not determine the velocities.
double KinematicSolver::find_orientation() const {
  const Tables& tables = system_.tables;
  if (tables.n_rows == 0) return 1.0;
  const MatrixXd matrix = select_active_rows(tables, find_closure_jacobian(tables, workspace_), size_);
  if (matrix.rows() != matrix.cols()) return 0.0;
  const Eigen::FullPivLU<MatrixXd> factors(matrix);
  const VectorXd pivots = factors.matrixLU().diagonal().cwiseAbs();
  if (!(pivots.minCoeff() > kSingularShare * pivots.maxCoeff())) return 0.0;
  return factors.determinant() > 0.0 ? 1.0 : -1.0;
}

// Moves next_ onto the closures; false when they do not close near to where it is.
bool KinematicSolver::close_nearby(double time) {
  update(time);
  const std::vector<double> predicted = next_.q;
  if (!close_loops()) return false;
  for (std::size_t k = 0; k < predicted.size(); ++k) {
    if (std::abs(next_.q[k] - predicted[k]) > kLargestCorrection * find_unit(k)) return false;
  }
  return true;
}

bool KinematicSolver::try_step(double time) {
  const double h = time - point_.time;
  for (std::size_t k = 0; k < point_.q.size(); ++k) {
    next_.q[k] = point_.q[k] + h * (point_.v[k] + 0.5 * h * point_.a[k]);
  }
  return close_nearby(time) && find_orientation() == orientation_ && find_motion() && !has_kink();
}

// Whether the velocities of next_ are not those that the current point foretells. A driver that leaves its rest does so
// by jerk alone, in steps of any length: its own share in what is not foretold is allowed for.
bool KinematicSolver::has_kink() {
  const double h = next_.time - point_.time;
  double jump = 0.0;
  for (std::size_t k = 0; k < point_.v.size(); ++k) {
    jump = std::max(jump, std::abs(next_.v[k] - point_.v[k] - h * point_.a[k]) / find_unit(k));
  }
  const double rate = std::max(find_largest_rate(point_), find_largest_rate(next_));
  if (jump <= kKink * rate) return false;
  const std::vector<DrivenValue> now = workspace_.coordinates.driven;
  update_coordinates(system_.tables, point_.time, point_.q.data(), point_.v.data(), workspace_.coordinates);
  const std::vector<DrivenValue> before = workspace_.coordinates.driven;
  double share = 0.0;
  for (std::size_t d = 0; d < now.size(); ++d) {
    const double asked = std::max(std::abs(now[d].rate), std::abs(before[d].rate));
    const double kink = std::abs(now[d].rate - before[d].rate - h * before[d].acceleration);
    if (asked > 0.0) share = std::max(share, kink / asked);
  }
  eval_dynamics(system_.tables, next_.time, next_.q.data(), next_.v.data(), {}, {}, workspace_);
  return jump > (kKink + share) * rate;
}

bool KinematicSolver::move_to(double time) {
  failure_.reset();
  double step = time - point_.time;
  while (point_.time != time) {
    const double left = time - point_.time;
    const bool last = std::abs(step) >= std::abs(left);
    if (try_step(last ? time : point_.time + step)) {
      std::swap(point_, next_);
      choose_rows();
      step *= 2.0;
      continue;
    }
    step = 0.5 * (last ? left : step);
    if (std::abs(step) > kLeastStep * std::max(std::abs(left), std::abs(point_.time))) continue;
    fail(MotionFailure::Kind::singular);
    if (failure_->kind == MotionFailure::Kind::singular && !closes_beyond(left)) {
      failure_->kind = MotionFailure::Kind::out_of_reach;
    }
    return_to(MotionPoint(point_));
    return false;
  }
  return true;
}

// Whether the loops close a little further on, in the direction of a time difference. Accelerations mean nothing where
// branches meet.
bool KinematicSolver::closes_beyond(double direction) {
  const double rate = find_largest_rate(point_);
  if (rate == 0.0) return false;
  const double h = std::copysign(kLookBeyond / rate, direction);
  for (std::size_t k = 0; k < point_.q.size(); ++k) next_.q[k] = point_.q[k] + h * point_.v[k];
  return close_nearby(point_.time + h);
}

double KinematicSolver::find_largest_rate(const MotionPoint& point) const {
  double largest = 0.0;
  for (std::size_t k = 0; k < point.v.size(); ++k) largest = std::max(largest, std::abs(point.v[k]) / find_unit(k));
  return largest;
}

// What a free coordinate is measured in: 1 rad, or the size [m].
double KinematicSolver::find_unit(std::size_t coordinate) const {
  return coordinate < static_cast<std::size_t>(system_.tables.counts.n_free_turns) ? 1.0 : size_;
}

void KinematicSolver::return_to(const MotionPoint& point) {
  point_ = point;
  evaluate_point();
  choose_rows();
}

void KinematicSolver::evaluate_point() {
  eval_dynamics(system_.tables, point_.time, point_.q.data(), point_.v.data(), {}, {}, workspace_);
}

// The determinant's sign is that of the rows enforced: it is taken anew where they change, at a position between
// singular ones.
void KinematicSolver::choose_rows() {
  while (row_choice_ && row_choice_->update(system_, workspace_)) {
    evaluate_point();
    note_usual_pivots(system_.tables, workspace_);
    orientation_ = find_orientation();
  }
}

void KinematicSolver::fail(MotionFailure::Kind kind) {
  failure_ = MotionFailure{kind, next_.time, {}};
  if (const int load = find_lost_load(workspace_); load >= 0) {
    failure_->kind = MotionFailure::Kind::lost_load;
    failure_->where = fmt::format("load '{}'", system_.mechanism.loads[load].name);
  } else if (!(workspace_.friction_margin > 0.0)) {
    failure_->kind = MotionFailure::Kind::jammed;
    failure_->where = fmt::format("joint '{}'", system_.mechanism.joints[workspace_.friction_joint].name);
  } else if (const int weakest = find_weakest_closure(system_.tables, workspace_); weakest >= 0) {
    failure_->where = name_closure(system_.mechanism, system_.topology, system_.topology.closures[weakest]);
  }
}

}  // namespace gudgeon
