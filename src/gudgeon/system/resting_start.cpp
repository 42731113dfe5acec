// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The equations of motion at the start, twice.
#include "gudgeon/system/resting_start.h"

#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/dynamics.h"

namespace gudgeon {

bool rests_on_contacts(const System& system, const State& start) {
  constexpr double kRestRounding = 1e-9;
  Workspace workspace(system.tables);
  BodyMotionFinder finder(system);
  std::vector<ContactMode> contact_modes(system.tables.contacts.size());
  const auto find_acceleration = [&] {
    eval_dynamics(system.tables, 0.0, start.q.data(), start.v.data(), contact_modes, {}, workspace);
    const std::vector<BodyMotion>& motions = finder.update(workspace);
    double sum = 0.0;
    for (std::size_t b = 1; b < motions.size(); ++b) {
      const Body& body = system.mechanism.bodies[b];
      sum += body.mass * dot(motions[b].acceleration, motions[b].acceleration) +
             body.inertia * motions[b].angle_acceleration * motions[b].angle_acceleration;
    }
    return sum;
  };
  const double free = find_acceleration();
  update_point_motions(system.tables, workspace);
  for (std::size_t k = 0; k < contact_modes.size(); ++k) {
    const Contact& contact = system.tables.contacts[k];
    contact_modes[k].in_contact = find_gap(contact.surfaces, find_contact_motion(contact, workspace)).penetration > 0.0;
  }
  return find_acceleration() <= (1.0 + kRestRounding) * free;
}

}  // namespace gudgeon
