// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How fast everything starts.
#pragma once

#include <Eigen/Dense>

#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// The smallest rates of the free coordinates that keep the loops closed and have every given start rate, at a position
/// that the workspace was updated for with all free rates zero. Throws ModelError when they conflict.
Eigen::VectorXd find_start_rates(const Mechanism& mechanism, const Topology& topology, const Tables& tables,
                                 const Workspace& workspace);

}  // namespace gudgeon
