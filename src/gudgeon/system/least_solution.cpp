// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// x = Mᵀ y with (M Mᵀ + ε) y = r, refined until rounding: the damping only slows the refinement, and keeps rows that
// depend on each other from dividing by nothing.
#include "gudgeon/system/least_solution.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace gudgeon {

Eigen::VectorXd find_least_solution(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& right) {
  constexpr double kDamping = 1e-11;  // [shares of the largest diagonal]
  constexpr int kMostRefinements = 30;
  using Sparse = Eigen::SparseMatrix<double>;
  const Sparse transpose = matrix.transpose();
  Sparse normal = matrix * transpose;
  double largest = 0.0;
  for (Eigen::Index k = 0; k < normal.rows(); ++k) largest = std::max(largest, normal.coeff(k, k));
  if (!(largest > 0.0)) return Eigen::VectorXd::Zero(matrix.cols());
  Sparse damping(normal.rows(), normal.cols());
  damping.setIdentity();
  normal += kDamping * largest * damping;
  const Eigen::SimplicialLDLT<Sparse> factors(normal);
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(matrix.cols());
  Eigen::VectorXd rest = right;
  for (int pass = 0; pass < kMostRefinements && rest.norm() > 0.0; ++pass) {
    const Eigen::VectorXd refined = solution + transpose * factors.solve(rest);
    const Eigen::VectorXd left = right - matrix * refined;
    if (!(left.norm() < 0.9 * rest.norm())) break;
    solution = refined;
    rest = left;
  }
  return solution;
}

}  // namespace gudgeon
