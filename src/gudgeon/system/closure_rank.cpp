// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The Jacobian term by term, and Gram-Schmidt over its rows.
#include "gudgeon/system/closure_rank.h"

namespace gudgeon {

Eigen::MatrixXd find_closure_jacobian(const Tables& tables, const Workspace& workspace) {
  const Coordinates& at = workspace.coordinates;
  const CoordinateCounts& counts = tables.counts;
  Eigen::MatrixXd jacobian =
      Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(tables.closures.size()), counts.n_free());
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    const ClosureRows& rows = tables.closures[c];
    const auto row = static_cast<Eigen::Index>(2 * c);
    const Vec2 normal = at.rotation[rows.line_turn] * rows.normal;
    if (rows.kind == ClosureKind::angle) {
      for (int k = 0; k < 2; ++k) {
        if (rows.angle_turn[k] < counts.n_free_turns) jacobian(row, rows.angle_turn[k]) += k == 0 ? 1.0 : -1.0;
      }
    }
    const auto add = [&](int column, Vec2 direction) {
      if (rows.kind == ClosureKind::line) {
        jacobian(row, column) += dot(normal, direction);
      } else {
        jacobian(row, column) += direction.x;
        jacobian(row + 1, column) += direction.y;
      }
    };
    Vec2 gap;
    for (int t = rows.first_term; t < rows.end_term; ++t) {
      const ClosureTerm& term = tables.closure_terms[t];
      const Vec2 arm = at.rotation[term.turn] * term.vector;
      gap += at.slide[term.slide] * arm;
      if (term.turn < counts.n_free_turns) add(term.turn, at.slide[term.slide] * perp(arm));
      if (term.slide < counts.n_free_slides) add(counts.n_free_turns + term.slide, arm);
    }
    if (rows.kind == ClosureKind::line && rows.line_turn < counts.n_free_turns) {
      jacobian(row, rows.line_turn) += cross(normal, gap);
    }
  }
  return jacobian;
}

namespace {

Eigen::VectorXd flatten(const std::vector<Vec2>& vectors) {
  Eigen::VectorXd flat(2 * static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    flat(static_cast<Eigen::Index>(2 * k)) = vectors[k].x;
    flat(static_cast<Eigen::Index>(2 * k + 1)) = vectors[k].y;
  }
  return flat;
}

}  // namespace

Eigen::VectorXd find_closure_gaps(const Workspace& workspace) { return flatten(workspace.closure_gap); }

Eigen::VectorXd find_closure_rates(const Workspace& workspace) { return flatten(workspace.closure_rate); }

RowRank find_row_rank(const Tables& tables, const Eigen::MatrixXd& jacobian) {
  RowRank result;
  const double largest = jacobian.size() > 0 ? jacobian.rowwise().norm().maxCoeff() : 0.0;
  Eigen::MatrixXd basis(jacobian.cols(), 0);
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    result.active.push_back({false, false});
    for (int k = 0; k < count_rows(tables.closures[c].kind); ++k) {
      Eigen::VectorXd rest = jacobian.row(static_cast<Eigen::Index>(2 * c) + k).transpose();
      // Twice is enough to be orthogonal to rounding.
      for (int pass = 0; pass < 2; ++pass) rest -= basis * (basis.transpose() * rest);
      if (rest.norm() <= kRankThreshold * largest) continue;
      basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
      basis.rightCols(1) = rest.normalized();
      result.active.back()[k] = true;
      ++result.rank;
    }
  }
  return result;
}

}  // namespace gudgeon
