// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Forces of the loads that depend on the state.
#pragma once

#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Adds all variable loads: forces to workspace.point_loads, torques to workspace.equations, and what each of them does
/// to workspace.loads. Needs coordinates and point motions.
void add_variable_loads(const Tables& tables, double t, Workspace& workspace) noexcept;

/// The values of all channels that loads depend on, in workspace.loads; needs coordinates and point motions.
void update_load_channels(const Tables& tables, double t, Workspace& workspace) noexcept;

/// The values of all channels that loads depend on, and the breaks of all formulas with the pieces that are held, in
/// workspace.loads; needs coordinates and point motions.
void update_breaks(const Tables& tables, double t, Workspace& workspace) noexcept;

/// Energy [J] stored in springs, torsion springs and bushings, from the last evaluation.
double find_spring_energy(const Workspace& workspace) noexcept;

/// The first load whose force or torque of the last evaluation is not a finite number: its index, or -1.
int find_lost_load(const Workspace& workspace) noexcept;

}  // namespace gudgeon
