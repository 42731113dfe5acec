// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Closure rows that say what others already say, and positions where rows only seem to.
#pragma once

#include "gudgeon/system/closure_rank.h"

namespace gudgeon {

struct Redundancy {
  ActiveRows active;         ///< independent rows, one entry a closure
  int n_redundant_rows = 0;  ///< rows implied by others wherever the mechanism goes
  bool singular = false;     ///< more rows depend on each other here than at neighbouring positions
  /// A free coordinate that closures hold to second order only: no row sees it move, and yet it cannot, as the middle
  /// of two bars in line. -1 without any.
  int held_coordinate = -1;
};

/// Looks at the closures of all rows in the position q at time t and, where rows depend on each other, also beside it:
/// a true redundancy stays, a singular position does not. The tables must have all rows active.
Redundancy find_redundancy(const Tables& tables, double t, const std::vector<double>& q);

}  // namespace gudgeon
