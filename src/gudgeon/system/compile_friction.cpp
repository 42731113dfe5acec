// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One entry a joint, in the model's order.
#include "gudgeon/system/compile_friction.h"

#include <memory>

namespace gudgeon {

namespace {

FrictionKind find_kind(const AnyJoint& joint) {
  if (std::holds_alternative<Prismatic>(joint)) return FrictionKind::guide;
  return std::holds_alternative<PinInSlot>(joint) ? FrictionKind::slot : FrictionKind::pin;
}

FrictionJoint compile_joint(const Mechanism& mechanism, const Topology& topology, int j, Tables& tables) {
  const AnyJoint& kind = mechanism.joints[j].kind;
  const auto& [first_body, first_point] = topology.ends[j].first;
  const auto& [second_body, second_point] = topology.ends[j].second;
  FrictionJoint joint;
  joint.joint = j;
  joint.kind = find_kind(kind);
  joint.friction = *find_friction(kind);
  joint.first_turn = topology.bodies[first_body].turn;
  joint.second_turn = topology.bodies[second_body].turn;
  joint.first_offset = topology.bodies[first_body].offset;
  joint.first_index = tables.find_turn_index(joint.first_turn);
  joint.second_index = tables.find_turn_index(joint.second_turn);
  if (joint.kind != FrictionKind::pin) {
    joint.direction = find_line_direction(kind);
    joint.first_row = tables.points.add(topology.find_path(first_body, first_point), topology.counts);
    joint.second_row = tables.points.add(topology.find_path(second_body, second_point), topology.counts);
  }
  if (has_bristle(joint.friction.law)) joint.bristle = tables.n_bristles++;
  joint.bristle_scale = find_bristle_scale(joint.friction.law);
  return joint;
}

}  // namespace

void compile_friction(const Mechanism& mechanism, const Topology& topology, Tables& tables) {
  int n_actions = 0;
  for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
    if (find_friction(mechanism.joints[j].kind) == nullptr) continue;
    FrictionJoint joint = compile_joint(mechanism, topology, j, tables);
    joint.first_action = n_actions;
    n_actions += count_actions(joint.kind);
    tables.friction_joints.push_back(joint);
  }
  if (n_actions == 0) return;
  tables.friction_bodies = std::make_shared<const FrictionBodies>(FrictionBodies{mechanism, topology});
}

}  // namespace gudgeon
