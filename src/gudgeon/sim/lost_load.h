// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which load a motion cannot go on because of.
#pragma once

#include <vector>

#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// The load that has no finite value at the state, or just ahead of it along its slopes: its index, or -1. Leaves the
/// equations evaluated somewhere near the state. smallest_step [s] is the one that steps had shrunk to.
int find_load_in_the_way(double time, double smallest_step, const std::vector<double>& y, MotionEquations& equations);

}  // namespace gudgeon
