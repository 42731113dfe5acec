// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Starts that only the play of clearance joints makes possible.
#pragma once

#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// Closes the ideal joints alone, from poses near to it, and keeps journals as little off centre as can be: the least
/// sum of squares of eccentricities in shares of their clearances. Values given for what the ideal joints leave free
/// are taken exactly where every journal then lies within its play. Finds the rates, too. False, the poses unchanged,
/// when a journal has no place in its bearing. Throws ModelError when start rates conflict.
bool close_within_play(const Mechanism& mechanism, double time, Assembly& assembly);

/// Moves poses with closed joints so that the displacements and places of bodies are had which a guide holds and no
/// other ideal joint, where every journal then lies within its play and one is clearly off the middle; other values
/// that were had stay. Finds the rates, too. False, the poses unchanged, otherwise.
bool shift_within_play(const Mechanism& mechanism, double time, Assembly& assembly);

/// Gives poses with closed joints rates that all given ones are had with, journals moving in their bearings where they
/// must, by the least sum of squares of their speeds in shares of their clearances. False, the poses unchanged, when
/// given rates conflict even so.
bool move_within_play(const Mechanism& mechanism, double time, Assembly& assembly);

}  // namespace gudgeon
