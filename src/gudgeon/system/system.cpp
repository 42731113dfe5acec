// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Compilation of the whole, and states from poses.
#include "gudgeon/system/system.h"

#include <algorithm>
#include <utility>

#include "gudgeon/system/compile_closures.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/redundancy.h"
#include "gudgeon/system/row_choice.h"

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
    const auto& [first, first_local] = topology.ends[joint].first;
    const auto& [second, second_local] = topology.ends[joint].second;
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
  const State state = make_state(system, assembly);
  const Redundancy redundancy = find_redundancy(compile_loops(mechanism, system.topology), 0.0, state.q);
  system.tables = compile_tables(mechanism, system.topology, &redundancy.active);
  if (redundancy.singular) return system;
  Workspace workspace(system.tables);
  const std::vector<ContactMode> open(system.tables.contacts.size());
  const auto evaluate = [&] { eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), open, {}, workspace); };
  evaluate();
  if (has_free_rows(system.tables)) {
    RowChoice choice(system);
    while (choice.update(system, workspace)) evaluate();
  }
  note_usual_pivots(system.tables, workspace);
  return system;
}

namespace {

// The depths of one of n surfaces that stand one after the other.
std::vector<double> find_part(std::span<const double> depths, int surface, int n) {
  const std::size_t size = depths.size() / static_cast<std::size_t>(n);
  const auto part = depths.subspan(static_cast<std::size_t>(surface) * size, size);
  return {part.begin(), part.end()};
}

void set_wear(RevoluteSurfaces& surfaces, std::vector<double> bearing, std::vector<double> journal) {
  surfaces.bearing_wear = RadialProfile(std::move(bearing));
  surfaces.journal_wear = RadialProfile(std::move(journal));
}

void set_wear(GuideSurfaces& surfaces, std::vector<double> bearing, std::vector<double> journal) {
  surfaces.bearing_wear = LineProfile(std::move(bearing), 2.0 * surfaces.half_length);
  surfaces.journal_wear = RadialProfile(std::move(journal));
}

}  // namespace

void set_surfaces(System& system, std::size_t group, std::span<const double> bearing_depths,
                  std::span<const double> journal_depths) {
  const ContactGroup& at = system.tables.contact_groups[group];
  for (int k = at.first_contact; k < at.end_contact; ++k) {
    Contact& contact = system.tables.contacts[k];
    std::vector<double> bearing = find_part(bearing_depths, contact.bearing_surface, at.n_bearing_surfaces);
    std::vector<double> journal = find_part(journal_depths, contact.journal_surface, at.n_journal_surfaces);
    std::visit([&](auto& surfaces) { set_wear(surfaces, std::move(bearing), std::move(journal)); }, contact.surfaces);
  }
}

}  // namespace gudgeon
