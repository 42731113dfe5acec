// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dense looks at the closure Jacobian, for everything that happens outside the time loop.
#pragma once

#include <Eigen/Dense>

#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// J of all closures at workspace.coordinates: two rows a closure (the second of a line is zero), one column a free
/// coordinate. Rows that are not enforced are included.
Eigen::MatrixXd find_closure_jacobian(const Tables& tables, const Workspace& workspace);

/// Gaps φ of all closures, two entries each, after update_closures.
Eigen::VectorXd find_closure_gaps(const Workspace& workspace);
/// Rates φ̇ of all closures, two entries each, after update_closures.
Eigen::VectorXd find_closure_rates(const Workspace& workspace);

/// What is left of a row beside those before it counts as zero below this share of the longest row.
inline constexpr double kRankThreshold = 1e-8;

struct RowRank {
  int rank = 0;
  ActiveRows active;  ///< a largest independent set of rows, earlier joints preferred
};

}  // namespace gudgeon
