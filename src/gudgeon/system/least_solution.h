// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The smallest solution of many equations of which each has few unknowns.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>

namespace gudgeon {

/// Beyond so many unknowns dense decompositions, whose cost grows with the cube, are left to sparse ones.
inline constexpr Eigen::Index kMostDenseUnknowns = 200;

/// x of least norm with matrix · x = right, rows that others imply among them. Equations that contradict each other
/// leave a residual.
Eigen::VectorXd find_least_solution(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& right);

}  // namespace gudgeon
