// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// In which order loops can be closed, and which of them only together.
#pragma once

#include <vector>

#include "gudgeon/system/tables.h"

namespace gudgeon {

/// Closures that together determine unknowns, once those of the groups before it are known: of a driver between two
/// bodies, a dyad, or a group of a higher class.
struct LoopGroup {
  std::vector<int> closures;
  std::vector<int> unknowns;   ///< free coordinates
  bool is_dyad = false;        ///< one joint's loop, with as many unknowns as it has rows
  bool is_determined = false;  ///< as many rows as unknowns, or more
};

/// Groups in an order in which they can be closed, drivers first, dyads before pairs of loops, and the rest as one.
/// Unknowns are free coordinates, one list a closure; some coordinates may be known beforehand. Only loops that share
/// an unknown are ever looked at together.
std::vector<LoopGroup> find_loop_groups(const Tables& tables, std::vector<std::vector<int>> unknowns,
                                        const std::vector<int>& known);

}  // namespace gudgeon
