// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// friction = { law = "...", ..., pin_radius = "10 mm" } of an ideal joint: a law's table, and sizes beside it.
#pragma once

#include <optional>

#include "gudgeon/io/read_law.h"
#include "gudgeon/model/friction_sizes.h"

namespace gudgeon {

/// The friction of a joint with these sizes; nothing where its table has none.
inline std::optional<JointFriction> read_joint_friction(TableReader& joint, std::span<const FrictionSize> sizes) {
  auto table = joint.find_table("friction", joint.subject() + ": friction");
  if (!table) return std::nullopt;
  JointFriction friction;
  friction.law = read_law<AnyFriction>(*table);
  for (const FrictionSize& size : sizes) {
    double& member = friction.*size.member;
    member = size.range.contains(0.0) ? table->find_quantity(size.key, size.dimension).value_or(0.0)
                                      : table->read_quantity(size.key, size.dimension);
  }
  table->check_unknown_keys();
  return friction;
}

}  // namespace gudgeon
