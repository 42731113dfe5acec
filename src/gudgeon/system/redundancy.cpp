// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rank here, and rank a small way along the motion that the joints permit.
#include "gudgeon/system/redundancy.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gudgeon/system/dynamics.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Far enough for singular values to rise well above the rank threshold, near enough to stay on the same branch.
constexpr double kNeighbourDistance = 1e-2;
// Dependent rows look independent where the loops do not close; this is far below the rank threshold.
constexpr double kClosedShare = 1e-11;
// Directions tried before a dependence of rows counts as permanent. Where several loops are singular at once, the
// position lies on several branches, some more than there are loops, and only on few of them all rows come free.
constexpr int kProbes = 24;

class RankProbe {
 public:
  explicit RankProbe(const Tables& tables) : tables_(tables), workspace_(tables), rest_(tables.counts.n_free(), 0.0) {}

  MatrixXd find_jacobian(double t, const VectorXd& q) {
    update(t, q);
    return find_closure_jacobian(tables_, workspace_);
  }

  // A position near q that still closes: drivers moved on, free motion followed in one of many directions. None where
  // the way back to closed loops was not found.
  std::optional<VectorXd> find_neighbour(double t, const VectorXd& q, int direction_index) {
    const MatrixXd jacobian = find_jacobian(t, q);
    Eigen::FullPivLU<MatrixXd> lu(jacobian);
    lu.setThreshold(kRankThreshold);
    VectorXd neighbour = q;
    if (lu.dimensionOfKernel() > 0) {
      const MatrixXd kernel = lu.kernel();
      // Uneven weights, so that no symmetry of the mechanism is kept by accident.
      VectorXd weights(kernel.cols());
      for (Index k = 0; k < weights.size(); ++k) {
        const double uneven = 1.0 + 0.37 * static_cast<double>(k);
        weights(k) = std::cos(direction_index * uneven) / uneven;
      }
      const VectorXd direction = kernel * weights;
      neighbour += kNeighbourDistance * direction / direction.cwiseAbs().maxCoeff();
    }
    // Levenberg-Marquardt damped with the gap goes to the nearest branch, where Newton's steps near a singular position
    // only halve the way back to it.
    for (int iteration = 0; iteration < 60; ++iteration) {
      const MatrixXd at = find_jacobian(t, neighbour);
      const VectorXd gaps = find_closure_gaps(workspace_);
      if (gaps.isZero(0.0)) break;
      MatrixXd normal = at.transpose() * at;
      normal.diagonal().array() += gaps.norm() * at.rowwise().norm().maxCoeff();
      neighbour -= normal.ldlt().solve(at.transpose() * gaps);
    }
    const double size = find_jacobian(t, neighbour).rowwise().norm().maxCoeff();
    if (!(find_closure_gaps(workspace_).norm() <= kClosedShare * size)) return std::nullopt;
    return neighbour;
  }

  /// What the drivers ask for where the probe was last.
  [[nodiscard]] const std::vector<DrivenValue>& driven() const { return workspace_.coordinates.driven; }

 private:
  void update(double t, const VectorXd& q) {
    update_coordinates(tables_, t, q.data(), rest_.data(), workspace_.coordinates);
    update_closures(tables_, workspace_);
  }

  const Tables& tables_;
  Workspace workspace_;
  std::vector<double> rest_;
};

// Until the first driver is that far on: the root of ½ a t² + v t = d. Zero when none moves.
double find_small_time(const std::vector<DrivenValue>& driven) {
  double soonest = std::numeric_limits<double>::infinity();
  for (const DrivenValue& at : driven) {
    const double rate = std::abs(at.rate);
    const double root = rate + std::sqrt(rate * rate + 2.0 * kNeighbourDistance * std::abs(at.acceleration));
    if (root > 0.0) soonest = std::min(soonest, 2.0 * kNeighbourDistance / root);
  }
  return std::isfinite(soonest) ? soonest : 0.0;
}

}  // namespace

Redundancy find_redundancy(const Tables& tables, double t, const std::vector<double>& q) {
  RankProbe probe(tables);
  const VectorXd here = VectorXd::Map(q.data(), static_cast<Index>(q.size()));
  const RowRank rank_here = find_row_rank(tables, probe.find_jacobian(t, here));
  // Where drivers hold everything there is nowhere to go.
  if (rank_here.rank == tables.n_rows || q.empty()) return {rank_here.active, tables.n_rows - rank_here.rank, false};

  RowRank best = rank_here;
  VectorXd best_at = here;
  const double later = t + find_small_time(probe.driven());
  for (int probes = 0; probes < kProbes && best.rank < tables.n_rows; ++probes) {
    // From here anew, and from the best so far, where independent loops come free one after the other.
    const auto neighbour = probe.find_neighbour(later, probes % 2 == 0 ? here : best_at, probes / 2);
    // Back where it began nothing is learned.
    if (!neighbour || (later == t && (*neighbour - here).cwiseAbs().maxCoeff() < 0.1 * kNeighbourDistance)) continue;
    const RowRank rank = find_row_rank(tables, probe.find_jacobian(later, *neighbour));
    if (rank.rank <= best.rank) continue;
    best = rank;
    best_at = *neighbour;
  }
  return {best.active, tables.n_rows - best.rank, best.rank > rank_here.rank};
}

}  // namespace gudgeon
