// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Summation over bodies and loads.
#include "gudgeon/system/kinetic_terms.h"

namespace gudgeon {

std::map<TermKey, Vec2> merge_terms(const Path& path) {
  std::map<TermKey, Vec2> merged;
  for (const Term& term : path) merged[{term.turn, term.slide}] += term.vector;
  return merged;
}

KineticTerms sum_kinetic_terms(const Mechanism& mechanism, const Topology& topology) {
  KineticTerms sums;
  sums.turn_inertia.assign(topology.counts.n_turns(), 0.0);
  sums.turn_torque.assign(topology.counts.n_turns(), 0.0);
  const auto add_force = [&](const Path& path, Vec2 force) {
    for (const auto& [key, vector] : merge_terms(path)) sums.fields[key].add(1.0, vector, force);
  };

  for (int b = 1; b < static_cast<int>(mechanism.bodies.size()); ++b) {
    const Body& body = mechanism.bodies[b];
    const Path path = topology.find_path(b, body.center_of_mass);
    sums.turn_inertia[topology.bodies[b].turn] += body.inertia;
    add_force(path, body.mass * mechanism.gravity);
    const auto terms = merge_terms(path);
    for (auto first = terms.begin(); first != terms.end(); ++first) {
      for (auto second = first; second != terms.end(); ++second) {
        sums.pairs[{first->first, second->first}].add(body.mass, first->second, second->second);
      }
    }
  }

  const NameIndex names(mechanism);
  for (const Load& load : mechanism.loads) {
    if (const auto* force = std::get_if<ConstantForce>(&load.kind)) {
      const JointEnd end = find_end(names, force->point);
      add_force(topology.find_path(end.body, end.point), force->force);
    } else if (const auto* torque = std::get_if<ConstantTorque>(&load.kind)) {
      sums.turn_torque[topology.bodies[names.find_body(torque->body)].turn] += torque->torque;
    }
  }
  return sums;
}

}  // namespace gudgeon
