// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The equations of motion: accelerations, constraint forces, driver efforts and contact forces of one state.
#pragma once

#include <span>

#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Baumgarte's feedback of closure errors, φ̈ = −2 α φ̇ − β² φ [1/s]; zero without it. Eq. (24) of the paper.
struct Feedback {
  double alpha = 0.0;
  double beta = 0.0;
};

/// Angles, slides and their rates from free coordinates q, their rates v, and the drivers at time t. The coordinates
/// were made with the tables' driven motions.
void update_coordinates(const Tables& tables, double t, const double* q, const double* v,
                        Coordinates& coordinates) noexcept;

/// Positions and velocities of the points that contacts and loads act on, in workspace.point_motions.
void update_point_motions(const Tables& tables, Workspace& workspace) noexcept;

/// The state of one contact's gap; needs update_point_motions.
inline RelativeMotion find_contact_motion(const Contact& contact, const Workspace& workspace) noexcept {
  const auto& bearing = workspace.point_motions[contact.bearing_row];
  const auto& journal = workspace.point_motions[contact.journal_row];
  return find_contact_motion(contact, workspace.coordinates, bearing.position, bearing.velocity, journal.position,
                             journal.velocity);
}

/// Solves [H Jᵀ; J 0] [q̈; −λ] = [Q; γ] for the state (t, q, v, workspace.bristles) with the given contact modes, one a
/// contact. Writes all of the workspace; the accelerations are workspace.equations[0 … n_free). No allocation, no
/// exception.
void eval_dynamics(const Tables& tables, double t, const double* q, const double* v,
                   std::span<const ContactMode> contact_modes, Feedback feedback, Workspace& workspace) noexcept;

/// What each driver delivers [N m, N], given the solved equations with the forces on driven coordinates behind them and
/// the matrix entries by slot, of which the couplings are read (Eq. D13).
void find_efforts(const Tables& tables, std::span<const double> values, std::span<const double> equations,
                  std::span<double> effort) noexcept;

/// Closure gaps φ and rates φ̇ of a state, in workspace.closure_gap and closure_rate; needs update_coordinates.
void update_closures(const Tables& tables, Workspace& workspace) noexcept;

/// Solves H dq + Jᵀ μ = 0, J dq = −residual with the factors of the last evaluation: the least correction, weighted
/// with mass, that removes a residual given one a closure. correction has n_free entries.
void find_correction(const Tables& tables, std::span<const Vec2> residual, Workspace& workspace,
                     double* correction) noexcept;

/// How much smaller a pivot of the last evaluation is than at the start; grows with the inverse square of the distance
/// from a singular position.
double find_singular_closeness(const Tables& tables, const Workspace& workspace) noexcept;

/// The closure whose row has the least pivot against its value at the start, or -1 without closures.
int find_weakest_closure(const Tables& tables, const Workspace& workspace) noexcept;

/// Power [W] that the drivers deliver, from the last evaluation.
double find_driver_power(const Workspace& workspace) noexcept;

}  // namespace gudgeon
