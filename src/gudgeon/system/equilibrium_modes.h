// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Small motions about an equilibrium.
#pragma once

#include "gudgeon/system/equilibrium.h"
#include "gudgeon/system/motion_chart.h"

namespace gudgeon {

/// Modes of ÿ = −K y − C ẏ, with K and C by differences of accelerations around the chart's origin.
std::vector<EquilibriumMode> find_modes(const System& system, MotionChart& chart);

}  // namespace gudgeon
