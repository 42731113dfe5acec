// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// [M Φqᵀ; Φq 0] by Eigen's LU factorizations, dense or sparse.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <memory>
#include <vector>

namespace gudgeon::textbook {

/// Entries of Φq are set by their number in the list given to prepare(); each is written on both sides.
class SaddleSolver {
 public:
  enum class Kind { dense, sparse };
  struct Place {
    int row;     ///< of Φq
    int column;  ///< -1 for a column of the frame, which is written nowhere
  };

  /// Lays out the matrix with these masses, one a coordinate, and finds an order of elimination.
  void prepare(Kind kind, const std::vector<double>& masses, int n_rows, const std::vector<Place>& places);

  void set(std::size_t entry, double value) { *places_[entry].lower = *places_[entry].upper = value; }
  /// Factorizes the matrix and solves for the right-hand side.
  void solve();

  Eigen::VectorXd right;     ///< [Q; γ]
  Eigen::VectorXd solution;  ///< [q̈; λ]

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  struct Targets {
    double* lower;
    double* upper;
  };

  Eigen::MatrixXd dense_;
  Eigen::PartialPivLU<Eigen::MatrixXd> dense_factors_;
  Sparse sparse_;
  std::unique_ptr<Eigen::SparseLU<Sparse>> sparse_factors_;  // none for the dense kind
  std::vector<Targets> places_;
  std::unique_ptr<double> sink_ = std::make_unique<double>();
};

}  // namespace gudgeon::textbook
