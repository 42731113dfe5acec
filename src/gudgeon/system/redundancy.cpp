// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rank here, and rank a small way along the motion that the joints permit.
#include "gudgeon/system/redundancy.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/sparse_closures.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Far enough for singular values to rise well above the rank threshold, near enough to stay on the same branch.
constexpr double kNeighbourDistance = 1e-2;
// Dependent rows look independent where the loops do not close; this is far below the rank threshold.
constexpr double kNeighbourClosedShare = 1e-11;
// Directions tried before a dependence of rows counts as permanent. Where several loops are singular at once, the
// position lies on several branches, some more than there are loops, and only on few of them all rows come free.
constexpr int kProbes = 24;
// A step back to closed loops that leaves more than this of the gap is followed by one damped so much less.
constexpr double kHardlyNearer = 0.5;
constexpr double kLessDamping = 0.25;
// A direction that is left by all but this share on the way back to closed loops leads nowhere.
constexpr double kLeadingShare = 0.05;
// With more free directions than this, finding those that lead nowhere would take too long.
constexpr Index kMostFreeDirections = 60;

// Uneven numbers in (-1, 1), so that no symmetry of the mechanism is kept by accident.
VectorXd make_uneven(Index size, int seed) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
  VectorXd numbers(size);
  for (Index k = 0; k < size; ++k) numbers(k) = 2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0;
  return numbers;
}

class RankProbe {
 public:
  enum class Damping { kept, let_go };

  explicit RankProbe(const Tables& tables) : tables_(tables), workspace_(tables), rest_(tables.counts.n_free(), 0.0) {}

  SparseMatrix find_jacobian(double t, const VectorXd& q) {
    update(t, q);
    return find_sparse_jacobian(tables_, workspace_.coordinates);
  }

  // A position that closes, as near as possible to the one that a step along a direction leads to. None where the way
  // to closed loops was not found.
  std::optional<VectorXd> find_neighbour(double t, const VectorXd& q, const VectorXd& direction, Damping kind) {
    VectorXd neighbour = q;
    const double longest = direction.size() > 0 ? direction.cwiseAbs().maxCoeff() : 0.0;
    if (longest > 1e-9) neighbour += kNeighbourDistance * direction / longest;
    // Levenberg-Marquardt damped with the gap goes to the nearest branch, where Newton's steps near a singular position
    // only halve the way back to it. Across what is held to second order its steps hardly get nearer: there the damping
    // may be let go, though rows that depend on each other keep looking independent, as the gap goes with a square.
    Eigen::SimplicialLDLT<SparseMatrix> factors;
    SparseMatrix identity(q.size(), q.size());
    identity.setIdentity();
    double size = 0.0;
    double damping = 1.0;
    double last_gap = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 60; ++iteration) {
      const SparseMatrix at = find_jacobian(t, neighbour);
      size = std::sqrt((at.cwiseProduct(at) * VectorXd::Ones(at.cols())).maxCoeff());
      const VectorXd gaps = find_closure_gaps(workspace_);
      const double gap = gaps.norm();
      if (gap <= 1e-3 * kNeighbourClosedShare * size) break;
      if (kind == Damping::let_go && gap > kHardlyNearer * last_gap) damping *= kLessDamping;
      last_gap = gap;
      const SparseMatrix normal = at.transpose() * at + damping * gap * size * identity;
      if (iteration == 0) factors.analyzePattern(normal);
      factors.factorize(normal);
      neighbour -= factors.solve(at.transpose() * gaps);
    }
    update(t, neighbour);
    if (!(find_closure_gaps(workspace_).norm() <= kNeighbourClosedShare * size)) return std::nullopt;
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

// The free coordinate that moves most in the directions that no row sees and yet nothing moves in; -1 without any.
// Steps along all of them are taken at once, in as many mixtures as there are directions and a few more.
int find_held_coordinate(RankProbe& probe, double t, const VectorXd& here, const MatrixXd& basis) {
  if (basis.cols() == 0 || basis.cols() > kMostFreeDirections) return -1;
  MatrixXd ways(basis.cols(), 0);
  for (int k = 0; k < 2 * basis.cols() + 6; ++k) {
    const VectorXd direction = basis * make_uneven(basis.cols(), k);
    const auto neighbour = probe.find_neighbour(t, here, direction, RankProbe::Damping::let_go);
    if (!neighbour) continue;
    ways.conservativeResize(Eigen::NoChange, ways.cols() + 1);
    ways.rightCols(1) = basis.transpose() * (*neighbour - here) / kNeighbourDistance;
  }
  if (ways.cols() < basis.cols()) return -1;
  const Eigen::JacobiSVD<MatrixXd> decomposition(ways, Eigen::ComputeFullU);
  const VectorXd singular = decomposition.singularValues();
  const double least = singular(singular.size() - 1);
  if (singular(0) > kLeadingShare && least >= kLeadingShare * singular(0)) return -1;
  const VectorXd nowhere = basis * decomposition.matrixU().col(basis.cols() - 1);
  Index held = 0;
  nowhere.cwiseAbs().maxCoeff(&held);
  return static_cast<int>(held);
}

}  // namespace

Redundancy find_redundancy(const Tables& tables, double t, const std::vector<double>& q) {
  RankProbe probe(tables);
  const VectorXd here = VectorXd::Map(q.data(), static_cast<Index>(q.size()));
  const RowSpace rows_here(probe.find_jacobian(t, here));
  const RowRank rank_here = find_row_rank(tables, rows_here);
  // Where drivers hold everything there is nowhere to go.
  if (rank_here.rank == tables.n_rows || q.empty())
    return {rank_here.active, tables.n_rows - rank_here.rank, false, -1};

  RowRank best = rank_here;
  VectorXd best_at = here;
  const double later = t + find_small_time(probe.driven());
  for (int probes = 0; probes < kProbes && best.rank < tables.n_rows; ++probes) {
    // From here anew, and from the best so far, where independent loops come free one after the other.
    const VectorXd& from = probes % 2 == 0 ? here : best_at;
    const RowSpace rows(probe.find_jacobian(t, from));
    const VectorXd direction = rows.find_free_part(make_uneven(here.size(), probes / 2));
    const auto neighbour = probe.find_neighbour(later, from, direction, RankProbe::Damping::kept);
    // Back where it began nothing is learned.
    if (!neighbour || (later == t && (*neighbour - here).cwiseAbs().maxCoeff() < 0.1 * kNeighbourDistance)) continue;
    const RowRank rank = find_row_rank(tables, RowSpace(probe.find_jacobian(later, *neighbour)));
    if (rank.rank <= best.rank) continue;
    best = rank;
    best_at = *neighbour;
  }
  Redundancy found{best.active, tables.n_rows - best.rank, best.rank > rank_here.rank, -1};
  if (!found.singular && here.size() - rank_here.rank <= kMostFreeDirections) {
    found.held_coordinate = find_held_coordinate(probe, t, here, rows_here.find_free_basis());
  }
  return found;
}

}  // namespace gudgeon
