// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Scratch memory of one thread: everything an evaluation writes, allocated once.
#pragma once

#include <memory>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/system/coordinates.h"
#include "gudgeon/system/tables.h"

namespace gudgeon {

class FrictionSolver;

/// Nothing where no ideal joint has friction.
std::shared_ptr<FrictionSolver> make_friction_solver(const Tables& tables);

struct Workspace {
  explicit Workspace(const Tables& tables)
      : coordinates(tables.counts, tables.driven),
        values(tables.n_slots, 0.0),
        inverse_pivots(tables.n_solve, 0.0),
        factors(tables.n_slots, 0.0),
        solution(tables.n_solve, 0.0),
        equations(tables.n_indices, 0.0),
        effort(tables.driven.size(), 0.0),
        closure_gap(tables.closures.size()),
        closure_rate(tables.closures.size()),
        bristles(tables.n_bristles, 0.0),
        point_motions(tables.points.rows().size()),
        point_loads(tables.points.rows().size()),
        contact_motions(tables.contacts.size()),
        contact_forces(tables.contacts.size()),
        touches(tables.contacts.size(), false),
        loads(tables.loads),
        friction_forces(tables.friction_joints.size()),
        friction_solver(make_friction_solver(tables)) {}
  Workspace(const Workspace&) = delete;  // two would write to one solver
  Workspace& operator=(const Workspace&) = delete;
  Workspace(Workspace&&) = default;
  Workspace& operator=(Workspace&&) = default;

  /// Makes room for tables of the same mechanism in which other closure rows are enforced.
  void fit(const Tables& tables) {
    values.resize(static_cast<std::size_t>(tables.n_slots));
    factors.resize(static_cast<std::size_t>(tables.n_slots));
  }

  /// Tables must be those that the workspace fits, when it is saved and when it is loaded.
  void transfer(StateArchive& archive) {
    archive(coordinates, values, inverse_pivots, factors, solution, equations, effort, closure_gap, closure_rate);
    archive(bristles, point_motions, point_loads, contact_motions, contact_forces, touches, loads, friction_forces);
  }

  Coordinates coordinates;
  std::vector<double> values;  ///< matrix entries by slot; after a solve the factors
  std::vector<double> inverse_pivots;
  std::vector<double> factors;  ///< kept aside while a solution is refined
  std::vector<double> solution;
  std::vector<double> equations;   ///< right-hand side; after a solve accelerations, then −λ of each active row
  std::vector<double> effort;      ///< torque or force of each driver [N m, N], positive along its value
  std::vector<Vec2> closure_gap;   ///< φ [m] of each closure, (line, 0) for a line, (angle [rad], 0) for an angle
  std::vector<Vec2> closure_rate;  ///< φ̇ [m/s, rad/s]
  std::vector<double> bristles;    ///< z [m], part of the state: to be set before an evaluation
  std::vector<PointChain::PointMotion> point_motions;
  std::vector<Vec2> point_loads;                ///< force on each chain row [N]
  std::vector<RelativeMotion> contact_motions;  ///< of active contacts
  std::vector<ContactForces> contact_forces;
  std::vector<char> touches;  ///< whether a contact's forces are other than all zero
  LoadScratch loads;
  std::vector<FrictionForces> friction_forces;  ///< one an ideal joint with friction
  double friction_margin = 1.0;                 ///< of Eq. F15: at zero friction has no solution, or no single one
  int friction_joint = -1;                      ///< whose friction that is; -1 where nothing rubs
  std::shared_ptr<FrictionSolver> friction_solver;
};

}  // namespace gudgeon
