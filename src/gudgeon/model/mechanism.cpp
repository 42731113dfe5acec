// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Look-ups by name, and the ideal counterpart of a mechanism.
#include "gudgeon/model/mechanism.h"

#include <algorithm>

namespace gudgeon {

namespace {

template <class Named>
int find_named(const std::vector<Named>& items, std::string_view name) {
  const auto found = std::ranges::find(items, name, &Named::name);
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

template <class Kind>
AnyJoint make_ideal(const Kind& kind) {
  return kind;
}

AnyJoint make_ideal(const RevoluteClearance& kind) { return Revolute{kind.bearing, kind.journal}; }

AnyJoint make_ideal(const PrismaticClearance& kind) {
  return Prismatic{kind.bearing, kind.journal, kind.direction, kind.relative_angle, {}, {}};
}

AnyJoint make_ideal(const PinInSlotClearance& kind) { return PinInSlot{kind.bearing, kind.journal, kind.direction}; }

}  // namespace

int find_body(const Mechanism& mechanism, std::string_view name) { return find_named(mechanism.bodies, name); }

int find_joint(const Mechanism& mechanism, std::string_view name) { return find_named(mechanism.joints, name); }

const Point* find_point(const Body& body, std::string_view name) {
  const int index = find_named(body.points, name);
  return index < 0 ? nullptr : &body.points[index];
}

Mechanism make_ideal(const Mechanism& mechanism) {
  Mechanism ideal = mechanism;
  for (Joint& joint : ideal.joints) {
    joint.kind = std::visit([](const auto& kind) { return make_ideal(kind); }, joint.kind);
  }
  return ideal;
}

}  // namespace gudgeon
