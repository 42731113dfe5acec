// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mobility in the textbook count, and constraints that say the same thing twice.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/system/assembly.h"

namespace gudgeon {

struct Mobility {
  int n_bodies = 0;              ///< moving bodies
  int n_coordinates = 0;         ///< 3 a moving body
  int n_constraint_rows = 0;     ///< 2 a revolute or prismatic joint, 3 a rigid one, 1 a pin in a slot or driver
  int n_redundant_rows = 0;      ///< rows that others already imply
  int n_degrees_of_freedom = 0;  ///< coordinates − rows + redundant rows
  int n_unknowns = 0;            ///< coordinates that gudgeon integrates
  int n_closure_rows = 0;        ///< loop closures that gudgeon solves with them
  std::vector<std::string> redundant_constraints;  ///< in words, with the joint's name
  std::string held_to_second_order;  ///< a body or guide that no row sees move and that cannot move; empty without any
  bool singular_start = false;       ///< the start position has a lower rank than its neighbours
};

/// Counts and finds redundant constraints at the assembled start position.
Mobility find_mobility(const Mechanism& mechanism, const Assembly& assembly);
/// Assembles first; throws ModelError as assemble() does.
Mobility find_mobility(const Mechanism& mechanism);

}  // namespace gudgeon
