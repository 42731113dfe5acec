// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Gauss-Newton on the loop closures of a mechanism.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "gudgeon/system/start_quantity.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Free coordinates on their way to a position in which all loops are closed. Keeps references to what it is made of.
class LoopCloser {
 public:
  LoopCloser(const Mechanism& mechanism, const Topology& topology, const Tables& tables, double time);

  /// Brings the workspace up to date with q and v.
  void update();
  /// Closes the loops, and has every pinned start value exactly. Each step is the least change of the coordinates that
  /// closes the linearised loops, shortened so that no body turns by more than half a radian and the gaps shrink. False
  /// when the loops stay open; q is then where they were nearest to closed.
  bool close(std::span<const GivenStart> pinned = {});
  /// Given values that joints and drivers leave free where q is, each independent of those before it; and how many
  /// there could be.
  [[nodiscard]] std::vector<GivenStart> select_free(const std::vector<GivenStart>& given, int* n_free = nullptr);
  [[nodiscard]] StartQuantity find_quantity(const GivenStart& given) const;
  /// [m] The longest vector of any closure.
  [[nodiscard]] double size() const { return size_; }

  Workspace workspace;
  Eigen::VectorXd q;
  Eigen::VectorXd v;

 private:
  struct Pins {
    std::vector<bool> frozen;      // one a coordinate
    std::vector<GivenStart> rows;  // values that are no coordinate themselves
  };

  Pins set_pinned(std::span<const GivenStart> pinned);
  [[nodiscard]] Eigen::VectorXd find_gaps(const Pins& pins) const;
  [[nodiscard]] Eigen::MatrixXd find_jacobian(const Pins& pins) const;
  [[nodiscard]] Eigen::VectorXd find_step(const Pins& pins) const;

  const Mechanism* mechanism_;
  const Topology* topology_;
  const Tables* tables_;
  double time_;
  double size_ = 0.0;
};

}  // namespace gudgeon
