// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rank here, and rank a small way along the motion that the joints permit.
#include "gudgeon/system/redundancy.h"

#include <Eigen/Dense>

#include "gudgeon/system/dynamics.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Far enough for singular values to rise well above the rank threshold, near enough to stay on the same branch.
constexpr double kNeighbourDistance = 1e-2;

class RankProbe {
 public:
  RankProbe(const Tables& tables) : tables_(tables), workspace_(tables), rest_(tables.counts.n_free(), 0.0) {}

  MatrixXd find_jacobian(double t, const VectorXd& q) {
    update(t, q);
    return find_closure_jacobian(tables_, workspace_);
  }

  // A position near q that still closes: drivers moved on, free motion followed.
  VectorXd find_neighbour(double t, const VectorXd& q) {
    const MatrixXd jacobian = find_jacobian(t, q);
    Eigen::FullPivLU<MatrixXd> lu(jacobian);
    lu.setThreshold(kRankThreshold);
    VectorXd neighbour = q;
    if (lu.dimensionOfKernel() > 0) {
      const MatrixXd kernel = lu.kernel();
      // Uneven weights, so that no symmetry of the mechanism is kept by accident.
      VectorXd weights(kernel.cols());
      for (Index k = 0; k < weights.size(); ++k) weights(k) = 1.0 / (1.0 + 0.37 * static_cast<double>(k));
      const VectorXd direction = kernel * weights;
      neighbour += kNeighbourDistance * direction / direction.cwiseAbs().maxCoeff();
    }
    for (int iteration = 0; iteration < 20; ++iteration) {
      const MatrixXd at = find_jacobian(t, neighbour);
      neighbour -= at.completeOrthogonalDecomposition().solve(find_closure_gaps(workspace_));
    }
    return neighbour;
  }

 private:
  void update(double t, const VectorXd& q) {
    update_coordinates(tables_, t, q.data(), rest_.data(), workspace_.coordinates);
    update_closures(tables_, workspace_);
  }

  const Tables& tables_;
  Workspace workspace_;
  std::vector<double> rest_;
};

double find_small_time(const Tables& tables) {
  double fastest = 0.0;
  for (const DrivenMotion& motion : tables.driven) fastest = std::max(fastest, std::abs(motion.speed));
  return fastest > 0.0 ? kNeighbourDistance / fastest : 0.0;
}

}  // namespace

Redundancy find_redundancy(const Tables& tables, double t, const std::vector<double>& q) {
  RankProbe probe(tables);
  const VectorXd here = VectorXd::Map(q.data(), static_cast<Index>(q.size()));
  const RowRank rank_here = find_row_rank(tables, probe.find_jacobian(t, here));
  if (rank_here.rank == tables.n_rows) return {rank_here.active, 0, false};

  const double later = t + find_small_time(tables);
  const RowRank rank_beside = find_row_rank(tables, probe.find_jacobian(later, probe.find_neighbour(later, here)));
  const bool singular = rank_beside.rank > rank_here.rank;
  const RowRank& rank = singular ? rank_beside : rank_here;
  return {rank.active, tables.n_rows - rank.rank, singular};
}

}  // namespace gudgeon
