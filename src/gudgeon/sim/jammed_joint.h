// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which joint's friction a motion cannot go on because of.
#pragma once

#include <vector>

#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// The ideal joint whose friction has no solution, or no single one, at the state or just ahead of it along its slopes
/// (docs/theory/friction.md, Eq. F15): its index, or -1. Leaves the equations evaluated somewhere near the state.
/// smallest_step [s] is the one that steps had shrunk to.
int find_jammed_joint(double time, double smallest_step, const std::vector<double>& y, MotionEquations& equations);

}  // namespace gudgeon
