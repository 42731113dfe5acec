// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loops as sums of turned constant vectors, and angles between bodies.
#include "gudgeon/system/compile_closures.h"

#include "gudgeon/system/kinetic_terms.h"

namespace gudgeon {

namespace {

// The line of a prismatic joint or slot, in the axes of the first body's turn.
Vec2 find_along(const AnyJoint& joint, const BodyNode& first) {
  const Rotation along = make_rotation(first.offset + find_line_direction(joint));
  return {along.c, along.s};
}

double find_path_length(const Path& path) {
  double length = 0.0;
  for (const Term& term : path) length += norm(term.vector);
  return length;
}

// Second point minus first, and minus the driven displacement of a driven prismatic joint.
Path find_loop(const Mechanism& mechanism, const Topology& topology, int joint) {
  const auto& [first, second] = topology.ends[joint];
  Path loop = topology.find_path(second.body, second.point);
  for (Term term : topology.find_path(first.body, first.point)) {
    term.vector = -term.vector;
    loop.push_back(term);
  }
  if (topology.joint_slide[joint] >= 0) {
    const BodyNode& node = topology.bodies[first.body];
    loop.push_back({node.turn, topology.joint_slide[joint], -find_along(mechanism.joints[joint].kind, node)});
  }
  // Terms that both paths share cancel to nothing.
  const double length = find_path_length(loop);
  Path remaining;
  for (const auto& [key, vector] : merge_terms(loop)) {
    if (norm(vector) > 1e-15 * length) remaining.push_back({key.turn, key.slide, vector});
  }
  return remaining;
}

void add_joint(const Mechanism& mechanism, const Topology& topology, ClosureRows& rows, Tables& tables) {
  for (const Term& term : find_loop(mechanism, topology, rows.joint)) {
    tables.closure_terms.push_back({term.turn, term.slide, term.vector, {}, {}});
  }
  if (rows.kind != ClosureKind::line) return;
  const AnyJoint& kind = mechanism.joints[rows.joint].kind;
  const BodyNode& first = topology.bodies[topology.ends[rows.joint].first.body];
  rows.line_turn = first.turn;
  rows.normal = perp(find_along(kind, first));
}

}  // namespace

void compile_closures(const Mechanism& mechanism, const Topology& topology, const ActiveRows& active, Tables& tables) {
  const NameIndex names(mechanism);
  int row = topology.counts.n_free();
  for (std::size_t c = 0; c < topology.closures.size(); ++c) {
    const Closure& closure = topology.closures[c];
    ClosureRows rows{};
    rows.joint = closure.joint;
    rows.driver = closure.driver;
    rows.kind = closure.kind;
    for (int k = 0; k < 2; ++k) {
      rows.active[k] = active[c][k];
      rows.row[k] = rows.active[k] ? row++ : tables.bin_index();
      rows.angle_turn[k] = topology.counts.frame_turn();
    }
    rows.line_turn = topology.counts.frame_turn();
    rows.first_term = static_cast<int>(tables.closure_terms.size());
    if (closure.kind == ClosureKind::angle) {
      const Driver& driver = mechanism.drivers[topology.driven[closure.driver].driver];
      const auto& angle = std::get<DrivenAngle>(driver.target);
      rows.angle_turn[0] = topology.bodies[names.find_body(angle.body)].turn;
      rows.angle_turn[1] = topology.bodies[names.find_body(angle.against)].turn;
    } else {
      add_joint(mechanism, topology, rows, tables);
    }
    rows.end_term = static_cast<int>(tables.closure_terms.size());
    tables.closures.push_back(rows);
  }
}

}  // namespace gudgeon
