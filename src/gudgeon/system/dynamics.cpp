// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Coordinates from the state, the solution of the equations, and what follows from it (docs/theory/dynamics.md):
// [H Jᵀ; J 0] [q̈; −λ] = [Q − H_fd ẍ_d; γ − J_d ẍ_d]      (Eq. D11)
#include "gudgeon/system/dynamics.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/base/rotations.h"
#include "gudgeon/system/equations.h"
#include "gudgeon/system/friction_solver.h"

namespace gudgeon {

void update_coordinates(const Tables& tables, double t, const double* q, const double* v,
                        Coordinates& coordinates) noexcept {
  const CoordinateCounts& counts = tables.counts;
  const int n_free_turns = counts.n_free_turns;
  for (int k = 0; k < n_free_turns; ++k) {
    coordinates.angle[k] = q[k];
    coordinates.angle_rate[k] = v[k];
  }
  for (int k = 0; k < counts.n_free_slides; ++k) {
    coordinates.slide[k] = q[n_free_turns + k];
    coordinates.slide_rate[k] = v[n_free_turns + k];
  }
  for (std::size_t d = 0; d < tables.driven.size(); ++d) {
    const DrivenMotion& motion = tables.driven[d];
    coordinates.driven[d] = motion.is_uniform() ? DrivenValue{motion.start + motion.speed * t, motion.speed, 0.0}
                                                : coordinates.functions[d].eval(t);
  }
  for (int k = 0; k < counts.n_driven_turns; ++k) {
    coordinates.angle[n_free_turns + k] = coordinates.driven[k].value;
    coordinates.angle_rate[n_free_turns + k] = coordinates.driven[k].rate;
  }
  for (int k = 0; k < counts.n_driven_slides; ++k) {
    const DrivenValue& driven = coordinates.driven[counts.n_driven_turns + k];
    coordinates.slide[counts.n_free_slides + k] = driven.value;
    coordinates.slide_rate[counts.n_free_slides + k] = driven.rate;
  }
  make_rotations(coordinates.angle, coordinates.rotation.data());
}

void update_point_motions(const Tables& tables, Workspace& workspace) noexcept {
  tables.points.find_motions(workspace.coordinates, workspace.point_motions.data());
}

namespace {

// Pivots may be this much smaller than at the start before rounding in the elimination matters: errors grow with their
// inverse, and this leaves twelve digits.
constexpr double kRefinedCloseness = 1e4;
// Each pass gains as many digits as the pivots have left; two serve down to pivots of 1e-12.
constexpr int kRefinements = 2;

// Residual correction with the matrix as it was before its elimination: near a singular position the error of the
// accelerations then grows with the inverse of the distance, not with its square.
void refine(const Tables& tables, double t, std::span<const ContactMode> contact_modes, Feedback feedback,
            Workspace& ws) noexcept {
  const auto n = static_cast<std::ptrdiff_t>(tables.n_solve);
  std::ranges::copy(ws.values, ws.factors.begin());
  std::copy_n(ws.equations.begin(), n, ws.solution.begin());
  for (int pass = 0; pass < kRefinements; ++pass) {
    assemble_equations(tables, t, contact_modes, feedback, ws);
    tables.elimination.subtract_product(ws.values.data(), ws.solution.data(), ws.equations.data());
    tables.elimination.solve(ws.factors.data(), ws.inverse_pivots.data(), ws.equations.data());
    for (std::ptrdiff_t i = 0; i < n; ++i) ws.solution[i] += ws.equations[i];
  }
  std::copy_n(ws.solution.begin(), n, ws.equations.begin());
  std::copy_n(ws.factors.begin(), tables.elimination.n_values(), ws.values.begin());
}

}  // namespace

// A driver delivers what its own equation lacks once everything else is known; one between two moving bodies is a
// closure, and its torque is the multiplier λ.
// T_d = Σ_u H_du q̈_u + Σ_e H_de ẍ_e − J_dᵀ λ − Q_d      (Eq. D13)
void find_efforts(const Tables& tables, std::span<const double> values, std::span<const double> equations,
                  std::span<double> effort) noexcept {
  const int n_driven = tables.counts.n_driven();
  for (int d = 0; d < n_driven; ++d) effort[d] = -equations[tables.n_solve + d];
  for (const ClosureRows& rows : tables.closures) {
    if (rows.kind == ClosureKind::angle) effort[rows.driver] = rows.active[0] ? -equations[rows.row[0]] : 0.0;
  }
  for (const Coupling& coupling : tables.couplings) {
    effort[coupling.driven - tables.n_solve] += values[coupling.slot] * equations[coupling.other];
  }
}

void eval_dynamics(const Tables& tables, double t, const double* q, const double* v,
                   std::span<const ContactMode> contact_modes, Feedback feedback, Workspace& workspace) noexcept {
  update_coordinates(tables, t, q, v, workspace.coordinates);
  assemble_equations(tables, t, contact_modes, feedback, workspace);
  tables.elimination.factor_and_solve(workspace.values.data(), workspace.inverse_pivots.data(),
                                      workspace.equations.data());
  if (find_singular_closeness(tables, workspace) > kRefinedCloseness) {
    refine(tables, t, contact_modes, feedback, workspace);
  }
  find_efforts(tables, workspace.values, workspace.equations, workspace.effort);
  if (workspace.friction_solver) workspace.friction_solver->solve(tables, workspace);
}

void find_correction(const Tables& tables, std::span<const Vec2> residual, Workspace& workspace,
                     double* correction) noexcept {
  std::ranges::fill(workspace.equations, 0.0);
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    const ClosureRows& rows = tables.closures[c];
    workspace.equations[rows.row[0]] = -residual[c].x;
    if (rows.kind == ClosureKind::point) workspace.equations[rows.row[1]] = -residual[c].y;
  }
  tables.elimination.solve(workspace.values.data(), workspace.inverse_pivots.data(), workspace.equations.data());
  std::copy_n(workspace.equations.begin(), tables.counts.n_free(), correction);
}

double find_singular_closeness(const Tables& tables, const Workspace& workspace) noexcept {
  double closeness = 0.0;
  for (std::size_t k = 0; k < tables.usual_pivots.size(); ++k) {
    closeness = std::max(closeness, std::abs(workspace.inverse_pivots[k] * tables.usual_pivots[k]));
  }
  return closeness;
}

int find_weakest_closure(const Tables& tables, const Workspace& workspace) noexcept {
  int weakest = -1;
  double most = 0.0;
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    for (int k = 0; k < 2; ++k) {
      if (!tables.closures[c].active[k] || tables.usual_pivots.empty()) continue;
      const int at = tables.elimination.find_slot(tables.closures[c].row[k], tables.closures[c].row[k]);
      const double ratio = std::abs(workspace.inverse_pivots[at] * tables.usual_pivots[at]);
      if (!(ratio <= most)) most = ratio, weakest = static_cast<int>(c);
    }
  }
  return weakest;
}

double find_driver_power(const Workspace& workspace) noexcept {
  double power = 0.0;
  for (std::size_t d = 0; d < workspace.effort.size(); ++d)
    power += workspace.effort[d] * workspace.coordinates.driven[d].rate;
  return power;
}

}  // namespace gudgeon
