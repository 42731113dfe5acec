// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Full matrices and plain vectors.
#include "gudgeon/system/closure_rank.h"

#include "gudgeon/system/sparse_closures.h"

namespace gudgeon {

Eigen::MatrixXd find_closure_jacobian(const Tables& tables, const Workspace& workspace) {
  return find_sparse_jacobian(tables, workspace.coordinates);
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

}  // namespace gudgeon
