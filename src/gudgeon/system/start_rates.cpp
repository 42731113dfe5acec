// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Least squares over closures and given rates.
#include "gudgeon/system/start_rates.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/closure_rank.h"
#include "gudgeon/system/least_solution.h"
#include "gudgeon/system/sparse_closures.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rates that are missed by less, against the largest one, are had.
constexpr double kHadShare = 1e-9;

bool is_driven_turn(const Topology& topology, int turn) {
  return turn >= topology.counts.n_free_turns && turn != topology.counts.frame_turn();
}

// A row of the equations for the rates of the free coordinates.
struct RateRow {
  std::vector<std::pair<int, double>> entries;  // by free coordinate
  double right = 0.0;
};

// A loose body is given the velocity of its origin; its coordinates are those of its centre of mass, which turns about
// it at the rate given for the body, a driver's, or none.
RateRow make_loose_row(const Mechanism& mechanism, const Topology& topology, const GivenStart& given, int slide,
                       const Coordinates& at) {
  const Body& body = mechanism.bodies[given.index];
  const BodyNode& node = topology.bodies[given.index];
  const Vec2 arm = make_rotation(at.angle[node.turn] + node.offset) * body.center_of_mass;
  const Vec2 turning = body.start.angle_rate.value_or(at.angle_rate[node.turn]) * perp(arm);
  const bool is_x = given.kind == GivenStart::Kind::x;
  return {{{topology.counts.n_free_turns + slide + (is_x ? 0 : 1), 1.0}}, given.value + (is_x ? turning.x : turning.y)};
}

RateRow make_row(const Mechanism& mechanism, const Topology& topology, const GivenStart& given, const Coordinates& at) {
  if (given.kind == GivenStart::Kind::x || given.kind == GivenStart::Kind::y) {
    for (const auto& [body, slide] : topology.loose) {
      if (body == given.index) return make_loose_row(mechanism, topology, given, slide, at);
    }
  }
  // With all free rates zero, the quantity's rate is what the drivers give it.
  const StartQuantity quantity = find_quantity(mechanism, topology, given, at);
  return {quantity.gradient, given.value - quantity.rate};
}

[[noreturn]] void throw_rate_conflict(const VectorXd& rest, const std::vector<GivenStart>& given, double had) {
  Diagnostics diagnostics;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const double missed = rest(static_cast<Index>(k));
    if (std::abs(missed) <= had) continue;
    diagnostics.error("E-MODEL-071", given[k].path,
                      fmt::format("start rates conflict: {} is {:.6g} (SI), and it is missed by {:.3g}", given[k].name,
                                  given[k].value, missed),
                      {"give as many start rates as the mechanism has degrees of freedom, no more; joints, drivers and "
                       "other start rates determine the rest"});
  }
  if (!diagnostics.has_errors()) {
    diagnostics.error("E-MODEL-072", "", "the drivers ask for speeds that the joints do not permit here",
                      {"the start position is singular or the drivers contradict each other"});
  }
  throw ModelError(diagnostics);
}

}  // namespace

std::vector<GivenStart> list_undriven_rates(const Mechanism& mechanism, const Topology& topology) {
  std::vector<GivenStart> given = list_given_rates(mechanism);
  std::erase_if(given, [&](const GivenStart& one) {
    if (one.kind == GivenStart::Kind::displacement) {
      const int slide = topology.joint_slide[one.index];
      return slide >= topology.counts.n_free_slides && slide != topology.counts.unit_slide();
    }
    return one.kind == GivenStart::Kind::angle && is_driven_turn(topology, topology.bodies[one.index].turn);
  });
  return given;
}

VectorXd solve_in_order(const MatrixXd& matrix, const VectorXd& right, const MatrixXd& wished,
                        const VectorXd& wished_right) {
  if (matrix.cols() == 0) return {};  // all is driven
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(kRankThreshold);
  solver.compute(matrix);
  VectorXd x = matrix.rows() > 0 ? VectorXd(solver.solve(right)) : VectorXd(VectorXd::Zero(wished.cols()));
  if (wished.rows() == 0) return x;
  MatrixXd kernel = MatrixXd::Identity(wished.cols(), wished.cols());
  if (matrix.rows() > 0) {
    Eigen::ColPivHouseholderQR<MatrixXd> rows;
    rows.setThreshold(kRankThreshold);
    rows.compute(matrix.transpose());
    const MatrixXd basis = rows.householderQ();
    kernel = basis.rightCols(wished.cols() - rows.rank());
  }
  if (kernel.cols() == 0) return x;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> rest;
  rest.setThreshold(kRankThreshold);
  rest.compute(wished * kernel);
  return x + kernel * rest.solve(wished_right - wished * x);
}

VectorXd find_start_rates(const Mechanism& mechanism, const Topology& topology, const Tables& tables,
                          const Workspace& workspace, const std::vector<GivenStart>& given, const WishedRates& wished) {
  const auto n_given = static_cast<Index>(given.size());
  const Index n_closures = 2 * static_cast<Index>(tables.closures.size());
  VectorXd right(n_closures + n_given);
  std::vector<Eigen::Triplet<double>> entries;
  // With v = 0 the closure rates are what the drivers ask for.
  right.head(n_closures) = -find_closure_rates(workspace);
  const SparseMatrix closures = find_sparse_jacobian(tables, workspace.coordinates);
  for (Index column = 0; column < closures.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(closures, column); entry; ++entry) {
      entries.emplace_back(entry.row(), column, entry.value());
    }
  }
  for (Index k = 0; k < n_given; ++k) {
    const RateRow row = make_row(mechanism, topology, given[static_cast<std::size_t>(k)], workspace.coordinates);
    for (const auto& [column, derivative] : row.entries) entries.emplace_back(n_closures + k, column, derivative);
    right(n_closures + k) = row.right;
  }
  SparseMatrix matrix(n_closures + n_given, tables.counts.n_free());
  matrix.setFromTriplets(entries.begin(), entries.end());
  VectorXd rates = VectorXd::Zero(matrix.cols());
  if (rates.size() > kMostDenseUnknowns && wished.matrix.rows() == 0) {
    rates = find_least_solution(matrix, right);
  } else if (rates.size() > 0 && (matrix.rows() > 0 || wished.matrix.rows() > 0)) {
    rates = solve_in_order(MatrixXd(matrix), right, wished.matrix, wished.right);
  }
  if (matrix.rows() == 0) return rates;
  const VectorXd rest = matrix * rates - right;
  const double largest = (matrix.cwiseAbs() * rates.cwiseAbs()).maxCoeff();
  const double asked = find_largest_term_speed(tables, workspace.coordinates);
  const double had = kHadShare * std::max({right.cwiseAbs().maxCoeff(), largest, asked});
  if (rest.cwiseAbs().maxCoeff() > had) throw_rate_conflict(rest.tail(n_given), given, had);
  return rates;
}

}  // namespace gudgeon
