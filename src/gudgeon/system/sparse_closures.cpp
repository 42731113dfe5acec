// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Householder's reflections column by column of the transpose, in the order of the rows.
#include "gudgeon/system/sparse_closures.h"

#include <cmath>

#include "gudgeon/system/closure_entries.h"

namespace gudgeon {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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
  return jacobian;
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
