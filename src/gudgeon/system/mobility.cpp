// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The textbook count beside what the compiled system integrates.
#include "gudgeon/system/mobility.h"

#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/system/compile_closures.h"
#include "gudgeon/system/motion_chart.h"
#include "gudgeon/system/redundancy.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

namespace {

int count_joint_rows(const AnyJoint& joint) {
  if (has_clearance(joint)) return 0;
  if (std::holds_alternative<PinInSlot>(joint)) return 1;
  return std::holds_alternative<Rigid>(joint) ? 3 : 2;
}

std::string describe_row(const System& system, std::size_t closure, int row) {
  const Closure& at = system.topology.closures[closure];
  const std::string name = name_closure(system.mechanism, system.topology, at);
  if (at.kind == ClosureKind::line) return name + ": its line";
  if (at.kind == ClosureKind::angle) return name + ": its relative angle";
  return fmt::format("{}: its {} direction", name, row == 0 ? "x" : "y");
}

// Joints outside the tree within rigid bodies repeat both their rows, but for one row a pair of pins, which ties an
// angle.
void add_implied_rows(const Mechanism& mechanism, const Topology& topology, Mobility& mobility) {
  std::vector<int> tying;  // joints of which one row is not redundant
  for (const PinnedPair& pair : topology.pinned) {
    if (std::ranges::find(topology.redundant_ties, pair.joint) == topology.redundant_ties.end()) {
      tying.push_back(pair.joint);
    }
  }
  const auto take = [&](int joint) {
    const auto found = std::ranges::find(tying, joint);
    if (found == tying.end()) return false;
    tying.erase(found);
    return true;
  };
  std::vector<int> rest;
  for (const int joint : topology.implied) {
    const std::string& name = mechanism.joints[joint].name;
    if (take(joint)) {
      mobility.redundant_constraints.push_back(fmt::format("joint '{}': along the line from the other pin", name));
    } else {
      rest.push_back(joint);
    }
  }
  for (const int joint : rest) {
    const std::string& name = mechanism.joints[joint].name;
    mobility.redundant_constraints.push_back(fmt::format("joint '{}': its x direction", name));
    if (!tying.empty()) {
      tying.pop_back();
      continue;
    }
    mobility.redundant_constraints.push_back(fmt::format("joint '{}': its y direction", name));
  }
}

}  // namespace

Mobility find_mobility(const Mechanism& mechanism) { return find_mobility(mechanism, assemble(mechanism)); }

Mobility find_mobility(const Mechanism& mechanism, const Assembly& assembly) {
  System system{mechanism, find_topology(mechanism), {}};
  system.tables = compile_loops(mechanism, system.topology);
  const Redundancy redundancy = find_redundancy(system.tables, 0.0, make_state(system, assembly).q);

  Mobility mobility;
  mobility.n_bodies = static_cast<int>(mechanism.bodies.size()) - 1;
  mobility.n_coordinates = 3 * mobility.n_bodies;
  for (const Joint& joint : mechanism.joints) mobility.n_constraint_rows += count_joint_rows(joint.kind);
  mobility.n_constraint_rows += static_cast<int>(mechanism.drivers.size());
  for (const int joint : system.topology.redundant_ties) {
    if (std::holds_alternative<Revolute>(mechanism.joints[joint].kind)) continue;  // has no angle of its own
    mobility.redundant_constraints.push_back(
        fmt::format("joint '{}': its relative angle", mechanism.joints[joint].name));
  }
  add_implied_rows(mechanism, system.topology, mobility);
  for (std::size_t c = 0; c < system.tables.closures.size(); ++c) {
    for (int k = 0; k < count_rows(system.tables.closures[c].kind); ++k) {
      if (!redundancy.active[c][k]) mobility.redundant_constraints.push_back(describe_row(system, c, k));
    }
  }
  mobility.n_redundant_rows = static_cast<int>(mobility.redundant_constraints.size());
  mobility.n_degrees_of_freedom = mobility.n_coordinates - mobility.n_constraint_rows + mobility.n_redundant_rows;
  mobility.n_unknowns = system.topology.counts.n_free();
  mobility.n_closure_rows = system.tables.n_rows - redundancy.n_redundant_rows;
  mobility.singular_start = redundancy.singular;
  if (redundancy.held_coordinate >= 0)
    mobility.held_to_second_order = name_coordinate(system, redundancy.held_coordinate);
  return mobility;
}

}  // namespace gudgeon
