// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// All ways in which the loops of a mechanism can be closed.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <optional>
#include <vector>

#include "gudgeon/system/loop_closer.h"
#include "gudgeon/system/loop_folds.h"

namespace gudgeon {

/// Every position with closed loops, pinned coordinates staying where they are: dyads by their mirror images, groups
/// of a higher class by Gauss-Newton from many starts, until one more start is not expected to find another. None at
/// all when degrees of freedom are left, for then there is no counting them. The closer keeps its coordinates.
std::optional<std::vector<Eigen::VectorXd>> find_assemblies(const Topology& topology, const Tables& tables,
                                                            LoopCloser& closer, const std::vector<int>& pinned);

/// Starts scattered over all turns, and for slides as far as the longest loop reaches; the same ones every time.
class ScatteredStarts {
 public:
  explicit ScatteredStarts(const Tables& tables);
  /// Gives new values to coordinates of q.
  void scatter(const std::vector<int>& coordinates, Eigen::VectorXd& q);

 private:
  const Tables* tables_;
  double reach_ = 0.0;  // [m]
  std::uint64_t state_ = 0;
};

}  // namespace gudgeon
