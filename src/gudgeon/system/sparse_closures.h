// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The closure Jacobian without its zeros, its rank, and least solutions of equations with it.
#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseQR>

#include "gudgeon/system/closure_rank.h"

namespace gudgeon {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// As find_closure_jacobian(), sparse. Entries that may vary are kept where they are zero: the pattern stays. What is
/// only rounding of the terms that an entry is the sum of is zero.
SparseMatrix find_sparse_jacobian(const Tables& tables, const Coordinates& coordinates);

/// The largest sum of the speeds [m/s, rad/s] of a closure's terms: what they leave of it where they cancel out is
/// rounding.
double find_largest_term_speed(const Tables& tables, const Coordinates& coordinates);

/// The length of the longest row of a matrix.
double find_longest_row(const SparseMatrix& rows);

/// The rows of a matrix that are independent of those before them, to a share of the longest row, and the space they
/// span.
class RowSpace {
 public:
  /// Rows that are zero throughout, as the second ones of lines, never count.
  explicit RowSpace(const SparseMatrix& rows) : RowSpace(rows, find_longest_row(rows)) {}
  /// Rows of a larger matrix, whose longest row is given.
  RowSpace(const SparseMatrix& rows, double longest);

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] bool is_independent(Eigen::Index row) const { return independent_[static_cast<std::size_t>(row)]; }
  /// What of a vector no row sees.
  [[nodiscard]] Eigen::VectorXd find_free_part(const Eigen::VectorXd& vector) const;
  /// An orthonormal basis of all that no row sees, a column a direction.
  [[nodiscard]] Eigen::MatrixXd find_free_basis() const;

 private:
  Eigen::Index n_;
  int rank_ = 0;
  std::vector<bool> independent_;
  // Coordinates stand in the order in which rows use them up, so that reflections meet no others.
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_;
  Eigen::SparseQR<SparseMatrix, Eigen::NaturalOrdering<int>> factors_;  // of the transpose in that order
};

/// Which closure rows are independent of those before them.
RowRank find_row_rank(const Tables& tables, const RowSpace& rows);

}  // namespace gudgeon
