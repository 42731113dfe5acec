// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A mechanism with its integrator at the start of a motion.
#pragma once

#include <utility>

#include "gudgeon/sim/motion_integrator.h"
#include "gudgeon/system/dynamics.h"

namespace gudgeon {

struct IntegratedMotion {
  IntegratedMotion(const Mechanism& mechanism, Study settings, double cycle_time = 1.0)
      : study(std::move(settings)),
        assembly(assemble(mechanism)),
        system(compile(mechanism, assembly)),
        integrator(system, study, cycle_time),
        began(integrator.begin(make_state(system, assembly))) {}

  // The gap of one contact at the integrator's own state, all anew.
  ContactGap find_contact_gap(std::size_t contact) const {
    Workspace workspace(system.tables);
    const double* y = integrator.y().data();
    const auto n_free = static_cast<std::size_t>(system.tables.counts.n_free());
    update_coordinates(system.tables, integrator.time(), y, y + n_free, workspace.coordinates);
    update_point_motions(system.tables, workspace);
    const Contact& at = system.tables.contacts[contact];
    return find_gap(at.surfaces, find_contact_motion(at, workspace));
  }

  Study study;
  Assembly assembly;
  System system;
  MotionIntegrator integrator;
  bool began;
};

}  // namespace gudgeon
