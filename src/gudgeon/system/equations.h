// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Matrix and right-hand side of the equations of motion, summed up from the tables.
#pragma once

#include <span>

#include "gudgeon/system/dynamics.h"

namespace gudgeon {

/// Writes [H Jᵀ; J 0] into workspace.values and [Q; γ] into workspace.equations for workspace.coordinates at time t,
/// and all gaps, rates, contact forces and loads on the way.
void assemble_equations(const Tables& tables, double t, std::span<const ContactMode> contact_modes, Feedback feedback,
                        Workspace& workspace) noexcept;

/// Adds the virtual work of forces on the rows of the chain of points [N] to right-hand sides, at point motions that
/// are up to date; one a row. A row's force is handed down to the row it starts from.
void add_point_loads(const Tables& tables, const Workspace& workspace, std::span<Vec2> loads,
                     std::span<double> equations) noexcept;

}  // namespace gudgeon
