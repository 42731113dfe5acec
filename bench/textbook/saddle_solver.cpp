// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Layout of the matrix and its factorizations.
#include "bench/textbook/saddle_solver.h"

namespace gudgeon::textbook {

void SaddleSolver::prepare(Kind kind, const std::vector<double>& masses, int n_rows, const std::vector<Place>& places) {
  const int n = static_cast<int>(masses.size());
  const int size = n + n_rows;
  right = Eigen::VectorXd::Zero(size);
  solution = Eigen::VectorXd::Zero(size);

  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, masses[i]);
  for (const Place& place : places) {
    if (place.column < 0) continue;
    entries.emplace_back(n + place.row, place.column, 0.0);
    entries.emplace_back(place.column, n + place.row, 0.0);
  }
  sparse_ = Sparse(size, size);
  sparse_.setFromTriplets(entries.begin(), entries.end());
  sparse_.makeCompressed();
  if (kind == Kind::dense) {
    dense_ = sparse_;
    dense_factors_ = Eigen::PartialPivLU<Eigen::MatrixXd>(size);
  } else {
    sparse_factors_ = std::make_unique<Eigen::SparseLU<Sparse>>();
    sparse_factors_->analyzePattern(sparse_);
  }
  for (const Place& place : places) {
    if (place.column < 0) {
      places_.push_back({sink_.get(), sink_.get()});
    } else if (kind == Kind::dense) {
      places_.push_back({&dense_(n + place.row, place.column), &dense_(place.column, n + place.row)});
    } else {
      places_.push_back(
          {&sparse_.coeffRef(n + place.row, place.column), &sparse_.coeffRef(place.column, n + place.row)});
    }
  }
}

void SaddleSolver::solve() {
  if (sparse_factors_) {
    sparse_factors_->factorize(sparse_);
    solution = sparse_factors_->solve(right);
  } else {
    dense_factors_.compute(dense_);
    solution = dense_factors_.solve(right);
  }
}

}  // namespace gudgeon::textbook
