// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Closures and chart together are one system of equations that is regular near the start.
#include "gudgeon/system/motion_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gudgeon/system/closure_rank.h"
#include "gudgeon/system/dynamics.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Closed is when the largest gap is at rounding of the mechanism's size.
constexpr double kChartShare = 1e-14;
constexpr int kMostChartSteps = 30;

}  // namespace

double find_longest_arm(const Mechanism& mechanism) {
  double size = 0.0;
  for (const Body& body : mechanism.bodies) {
    size = std::max(size, norm(body.center_of_mass));
    for (const Point& point : body.points) size = std::max(size, norm(point.position));
  }
  return size > 0.0 ? size : 1.0;
}

std::string name_coordinate(const System& system, Index coordinate) {
  const auto at = static_cast<int>(coordinate);
  const Topology& topology = system.topology;
  if (at < topology.counts.n_free_turns) {
    for (std::size_t b = 1; b < topology.bodies.size(); ++b) {
      if (topology.bodies[b].turn == at) return system.mechanism.bodies[b].name;
    }
  }
  const int slide = at - topology.counts.n_free_turns;
  if (slide >= 0 && topology.free_slide_joint[slide] >= 0) {
    return system.mechanism.joints[topology.free_slide_joint[slide]].name;
  }
  for (const auto& [body, first] : topology.loose) {
    if (slide == first || slide == first + 1) return system.mechanism.bodies[body].name;
  }
  return {};
}

MotionChart::MotionChart(const System& system, const VectorXd& q)
    : system_(&system),
      workspace_(system.tables),
      scale_(VectorXd::Ones(q.size())),
      start_(q),
      q_(q),
      v_(VectorXd::Zero(q.size())),
      size_(find_longest_arm(system.mechanism)) {
  scale_.tail(system.tables.counts.n_free_slides).setConstant(size_);
  update();
  basis_ = MatrixXd::Identity(q.size(), q.size());
  if (system.tables.closures.empty() || q.size() == 0) return;
  const MatrixXd jacobian = find_closure_jacobian(system.tables, workspace_) * scale_.asDiagonal();
  Eigen::JacobiSVD<MatrixXd> decomposition(jacobian, Eigen::ComputeFullV);
  decomposition.setThreshold(kRankThreshold);
  basis_ = decomposition.matrixV().rightCols(q.size() - decomposition.rank());
}

void MotionChart::update() {
  update_coordinates(system_->tables, 0.0, q_.data(), v_.data(), workspace_.coordinates);
  update_closures(system_->tables, workspace_);
}

// [J S; Zᵀ] for changes of x.
MatrixXd MotionChart::find_matrix() const {
  const MatrixXd jacobian = find_closure_jacobian(system_->tables, workspace_);
  MatrixXd matrix(jacobian.rows() + basis_.cols(), jacobian.cols());
  matrix << jacobian * scale_.asDiagonal() / size_, basis_.transpose();
  return matrix;
}

bool MotionChart::move_to(const VectorXd& y) {
  q_ = start_ + scale_.cwiseProduct(basis_ * y);
  v_.setZero();
  update();
  if (system_->tables.closures.empty() || q_.size() == 0) return true;
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kMostChartSteps; ++iteration) {
    const VectorXd gaps = find_closure_gaps(workspace_) / size_;
    const double error = gaps.norm();
    if (!std::isfinite(error)) return false;
    if (error >= 0.5 * last && error <= 100.0 * kChartShare) return true;  // rounding: no more to gain
    last = error;
    VectorXd right = VectorXd::Zero(gaps.size() + basis_.cols());
    right.head(gaps.size()) = -gaps;
    q_ += scale_.cwiseProduct(Eigen::CompleteOrthogonalDecomposition<MatrixXd>(find_matrix()).solve(right));
    update();
  }
  return last <= 100.0 * kChartShare;
}

VectorXd MotionChart::find_acceleration(const VectorXd& rates) {
  v_.setZero();
  if (!rates.isZero(0.0)) {
    update();
    const MatrixXd matrix = find_matrix();
    VectorXd right = VectorXd::Zero(matrix.rows());
    right.tail(rates.size()) = rates;
    v_ = scale_.cwiseProduct(Eigen::CompleteOrthogonalDecomposition<MatrixXd>(matrix).solve(right));
  }
  eval_dynamics(system_->tables, 0.0, q_.data(), v_.data(), {}, {}, workspace_);
  accelerations_ = Eigen::Map<const VectorXd>(workspace_.equations.data(), q_.size()).cwiseQuotient(scale_);
  return basis_.transpose() * accelerations_;
}

}  // namespace gudgeon
