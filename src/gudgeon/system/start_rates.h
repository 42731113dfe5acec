// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How fast everything starts.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "gudgeon/system/start_quantity.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Start rates that drivers do not prescribe: those that a driver holds are left to a remark.
std::vector<GivenStart> list_undriven_rates(const Mechanism& mechanism, const Topology& topology);

/// What should hold as nearly as it can, once all that must hold does: matrix · v = right.
struct WishedRates {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

/// The smallest rates of the free coordinates that keep the loops closed and have every given start rate, at a position
/// that the workspace was updated for with all free rates zero; of those the ones nearest to what is wished. Throws
/// ModelError when they conflict.
Eigen::VectorXd find_start_rates(const Mechanism& mechanism, const Topology& topology, const Tables& tables,
                                 const Workspace& workspace, const std::vector<GivenStart>& given,
                                 const WishedRates& wished = {});

/// x with matrix · x = right in the sense of least squares, and of those the one that comes nearest to the wished
/// equations; what is left free is smallest.
Eigen::VectorXd solve_in_order(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                               const Eigen::MatrixXd& wished, const Eigen::VectorXd& wished_right);

}  // namespace gudgeon
