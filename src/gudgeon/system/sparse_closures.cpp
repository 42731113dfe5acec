// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Householder's reflections column by column of the transpose, in the order of the rows.
#include "gudgeon/system/sparse_closures.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/system/closure_entries.h"

namespace gudgeon {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// What is left of terms of that size by less than this is their rounding: guides beside one another have rows of it.
constexpr double kRounding = 1e-13;

// Sizes of the terms that a closure's entries are sums of: of turns [m] and of displacements [1].
struct TermSizes {
  double turns = 0.0;
  double slides = 0.0;
};

TermSizes find_term_sizes(const Tables& tables, const Coordinates& at, const ClosureRows& rows) {
  if (rows.kind == ClosureKind::angle) return {1.0, 0.0};
  TermSizes sizes;
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    const ClosureTerm& term = tables.closure_terms[t];
    sizes.turns += std::abs(at.slide[term.slide]) * norm(term.vector);
    sizes.slides += norm(term.vector);
  }
  return sizes;
}

}  // namespace

SparseMatrix find_sparse_jacobian(const Tables& tables, const Coordinates& coordinates) {
  std::vector<Eigen::Triplet<double>> entries;
  const int n_free = tables.counts.n_free();
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    visit_closure_entries(tables, coordinates, tables.closures[c], [&](int row, int index, double value) {
      if (index < n_free) entries.emplace_back(static_cast<int>(2 * c) + row, index, value);
    });
  }
  SparseMatrix jacobian(2 * static_cast<Index>(tables.closures.size()), n_free);
  jacobian.setFromTriplets(entries.begin(), entries.end());
  std::vector<TermSizes> sizes;
  for (const ClosureRows& rows : tables.closures) sizes.push_back(find_term_sizes(tables, coordinates, rows));
  for (Index column = 0; column < jacobian.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(jacobian, column); entry; ++entry) {
      const TermSizes& size = sizes[static_cast<std::size_t>(entry.row() / 2)];
      const double terms = column < tables.counts.n_free_turns ? size.turns : size.slides;
      if (std::abs(entry.value()) <= kRounding * terms) entry.valueRef() = 0.0;
    }
  }
  return jacobian;
}

double find_largest_term_speed(const Tables& tables, const Coordinates& coordinates) {
  double largest = 0.0;
  for (const ClosureRows& rows : tables.closures) {
    double sum = 0.0;
    if (rows.kind == ClosureKind::angle) {
      for (const int turn : rows.angle_turn) sum += std::abs(coordinates.angle_rate[turn]);
    }
    for (int t = rows.first_term; t < rows.end_term; ++t) {
      const ClosureTerm& term = tables.closure_terms[t];
      sum += norm(term.vector) * (std::abs(coordinates.slide[term.slide] * coordinates.angle_rate[term.turn]) +
                                  std::abs(coordinates.slide_rate[term.slide]));
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

double find_longest_row(const SparseMatrix& rows) {
  VectorXd squares = VectorXd::Zero(rows.rows());
  for (Index column = 0; column < rows.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(rows, column); entry; ++entry) {
      squares(entry.row()) += entry.value() * entry.value();
    }
  }
  return squares.size() > 0 ? std::sqrt(squares.maxCoeff()) : 0.0;
}

namespace {

// The place of every coordinate: each row in turn takes the one of its coordinates that later rows need least. Those
// left over come last. A reflection begins at the place of its own number, whatever coordinate stands there.
std::vector<int> find_order(const SparseMatrix& transpose) {
  std::vector<int> last_row(static_cast<std::size_t>(transpose.rows()), -1);
  for (int row = 0; row < transpose.cols(); ++row) {
    for (SparseMatrix::InnerIterator entry(transpose, row); entry; ++entry) last_row[entry.row()] = row;
  }
  std::vector<int> place(last_row.size(), -1);
  int next = 0;
  for (int row = 0; row < transpose.cols(); ++row) {
    Index best = -1;
    for (SparseMatrix::InnerIterator entry(transpose, row); entry; ++entry) {
      if (place[entry.row()] < 0 && (best < 0 || last_row[entry.row()] < last_row[best])) best = entry.row();
    }
    if (best >= 0) place[best] = next++;
  }
  for (int& one : place) {
    if (one < 0) one = next++;
  }
  return place;
}

}  // namespace

RowSpace::RowSpace(const SparseMatrix& rows, double longest)
    : n_(rows.cols()), independent_(static_cast<std::size_t>(rows.rows())) {
  if (!(longest > 0.0) || rows.nonZeros() == 0) return;
  const SparseMatrix columns = rows.transpose();
  const std::vector<int> order = find_order(columns);
  order_.indices() = Eigen::VectorXi::Map(order.data(), static_cast<Index>(order.size()));
  SparseMatrix ordered = order_ * columns;
  ordered.makeCompressed();
  factors_.setPivotThreshold(kRankThreshold * longest);
  factors_.compute(ordered);
  rank_ = static_cast<int>(factors_.rank());
  // Those that are not independent were moved to the end.
  for (Index k = 0; k < rank_; ++k) {
    independent_[static_cast<std::size_t>(factors_.colsPermutation().indices()(k))] = true;
  }
}

VectorXd RowSpace::find_free_part(const VectorXd& vector) const {
  if (rank_ == 0) return vector;
  VectorXd turned = factors_.matrixQ().transpose() * VectorXd(order_ * vector);
  turned.head(rank_).setZero();
  return order_.transpose() * VectorXd(factors_.matrixQ() * turned);
}

MatrixXd RowSpace::find_free_basis() const {
  if (rank_ == 0) return MatrixXd::Identity(n_, n_);
  MatrixXd basis = MatrixXd::Zero(n_, n_ - rank_);
  if (rank_ == n_) return basis;
  basis.bottomRows(n_ - rank_).setIdentity();
  return order_.transpose() * MatrixXd(factors_.matrixQ() * basis);
}

RowRank find_row_rank(const Tables& tables, const RowSpace& rows) {
  RowRank result;
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    std::array<bool, 2> active{false, false};
    for (int k = 0; k < count_rows(tables.closures[c].kind); ++k) {
      active[k] = rows.is_independent(static_cast<Index>(2 * c) + k);
      if (active[k]) ++result.rank;
    }
    result.active.push_back(active);
  }
  return result;
}

}  // namespace gudgeon
