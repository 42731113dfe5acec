// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which quantities move in the directions that closures leave free.
#pragma once

#include <utility>
#include <vector>

#include "gudgeon/system/sparse_closures.h"

namespace gudgeon {

/// How a quantity moves with the free coordinates that it depends on.
using Gradient = std::vector<std::pair<int, double>>;

struct FreeGradients {
  std::vector<int> free;  ///< indices of gradients that move, each independently of those before it, in their order
  int n_free = 0;         ///< so many there could be
};

/// Looks at each independent part of the coordinates by itself: parts that no closure row and no gradient connects.
FreeGradients find_free_gradients(const SparseMatrix& closures, const std::vector<Gradient>& gradients);

}  // namespace gudgeon
