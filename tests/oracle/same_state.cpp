// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// States by their poses.
#include "tests/oracle/same_state.h"

#include "tests/oracle/textbook_contacts.h"
#include "tests/oracle/textbook_start.h"

namespace gudgeon::oracle {

SameState make_free_start(const Mechanism& mechanism) {
  SameState state{assemble(mechanism), {}};
  for (const Joint& joint : mechanism.joints) {
    state.contact_modes.resize(state.contact_modes.size() + static_cast<std::size_t>(n_contacts(joint.kind)));
  }
  return state;
}

SameState make_pressed_start(const Mechanism& mechanism) {
  SameState state = make_free_start(mechanism);
  const TextbookState pressed = make_pressed_state(mechanism);
  for (std::size_t k = 1; k < mechanism.bodies.size(); ++k) {
    const oracle::TextbookBody& body = pressed.bodies[k];
    const Vec2 arm = make_rotation(body.angle) * mechanism.bodies[k].center_of_mass;
    state.assembly.poses[k] = {body.center - arm, body.angle, body.velocity - body.angle_rate * perp(arm),
                               body.angle_rate};
  }
  for (std::size_t k = 0; k < state.contact_modes.size(); ++k) {
    state.contact_modes[k] = {pressed.contacts[k].in_contact, pressed.contacts[k].onset_speed};
  }
  return state;
}

EngineAt::EngineAt(const Mechanism& mechanism, const SameState& at)
    : system(compile(mechanism, assemble(mechanism))), equations(system, {}), y(equations.size(), 0.0), slope(y) {
  const State state = gudgeon::make_state(system, at.assembly);
  std::ranges::copy(state.q, y.begin());
  std::ranges::copy(state.v, y.begin() + static_cast<std::ptrdiff_t>(equations.n_free()));
  equations.contact_modes = at.contact_modes;
}

}  // namespace gudgeon::oracle
