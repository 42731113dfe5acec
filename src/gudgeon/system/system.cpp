// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Compilation of the whole, and states from poses.
#include "gudgeon/system/system.h"

#include <utility>

#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/redundancy.h"

namespace gudgeon {

namespace {

Vec2 find_velocity(const BodyPose& pose, Vec2 local) {
  return pose.velocity + pose.angle_rate * perp(make_rotation(pose.angle) * local);
}

}  // namespace

State make_state(const System& system, const Assembly& assembly) {
  const Mechanism& mechanism = system.mechanism;
  const Topology& topology = system.topology;
  const CoordinateCounts& counts = topology.counts;
  State state{std::vector<double>(counts.n_free(), 0.0), std::vector<double>(counts.n_free(), 0.0)};
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const BodyNode& node = topology.bodies[b];
    if (node.turn >= counts.n_free_turns) continue;
    state.q[node.turn] = assembly.poses[b].angle - node.offset;
    state.v[node.turn] = assembly.poses[b].angle_rate;
  }
  for (const auto& [body, slide] : topology.loose) {
    const BodyPose& pose = assembly.poses[body];
    const Vec2 position = pose.find_point(mechanism.bodies[body].center_of_mass);
    const Vec2 velocity = find_velocity(pose, mechanism.bodies[body].center_of_mass);
    const int at = counts.n_free_turns + slide;
    state.q[at] = position.x, state.q[at + 1] = position.y;
    state.v[at] = velocity.x, state.v[at + 1] = velocity.y;
  }
  for (int s = 0; s < counts.n_free_slides; ++s) {
    const int joint = topology.free_slide_joint[s];
    if (joint < 0) continue;
    const auto& prismatic = std::get<Prismatic>(mechanism.joints[joint].kind);
    const int first = find_body(mechanism, prismatic.first.body);
    const int second = find_body(mechanism, prismatic.second.body);
    const Vec2 first_local = find_point(mechanism.bodies[first], prismatic.first.point)->position;
    const Vec2 second_local = find_point(mechanism.bodies[second], prismatic.second.point)->position;
    const Vec2 apart = assembly.poses[second].find_point(second_local) - assembly.poses[first].find_point(first_local);
    const Vec2 velocity =
        find_velocity(assembly.poses[second], second_local) - find_velocity(assembly.poses[first], first_local);
    const Rotation along = make_rotation(assembly.poses[first].angle + prismatic.direction);
    const Vec2 axis{along.c, along.s};
    state.q[counts.n_free_turns + s] = dot(apart, axis);
    state.v[counts.n_free_turns + s] = dot(velocity, axis) + assembly.poses[first].angle_rate * dot(apart, perp(axis));
  }
  return state;
}

System compile(const Mechanism& mechanism, const Assembly& assembly) {
  System system{mechanism, find_topology(mechanism), {}};
  system.tables = compile_tables(mechanism, system.topology);
  const Redundancy redundancy = find_redundancy(system.tables, 0.0, make_state(system, assembly).q);
  if (redundancy.n_redundant_rows > 0) {
    system.tables = compile_tables(mechanism, system.topology, &redundancy.active);
  }
  if (!redundancy.singular) {
    Workspace workspace(system.tables);
    const State state = make_state(system, assembly);
    const std::vector<ContactLatch> open(system.tables.contacts.size());
    eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), open, {}, workspace);
    system.tables.usual_inverse_pivots = workspace.inverse_pivots;
  }
  return system;
}

void set_surfaces(System& system, std::size_t contact, RadialProfile bearing_wear, RadialProfile journal_wear) {
  RevoluteSurfaces& surfaces = system.tables.contacts[contact].surfaces;
  surfaces.bearing_wear = std::move(bearing_wear);
  surfaces.journal_wear = std::move(journal_wear);
}

}  // namespace gudgeon
