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
  if constexpr (ClearanceJoint<Kind>) {
    return kind.make_ideal();
  } else {
    return kind;
  }
}

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

Mechanism make_ideal_with_friction(const Mechanism& mechanism) {
  Mechanism ideal = make_ideal(mechanism);
  for (std::size_t j = 0; j < ideal.joints.size(); ++j) {
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (ClearanceJoint<Kind>) {
            if (std::holds_alternative<Frictionless>(kind.contact.friction)) return;
            std::visit(
                [&](auto& joint) {
                  if constexpr (requires { joint.friction; }) joint.friction = kind.make_friction();
                },
                ideal.joints[j].kind);
          }
        },
        mechanism.joints[j].kind);
  }
  return ideal;
}

int find_bristled_slot(const Mechanism& mechanism) {
  const auto found = std::ranges::find_if(mechanism.joints, [](const Joint& joint) {
    const auto* slot = std::get_if<PinInSlotClearance>(&joint.kind);
    return slot != nullptr &&
           std::visit([]<class Law>(const Law&) { return Law::kHasBristle; }, slot->contact.friction);
  });
  return found == mechanism.joints.end() ? -1 : static_cast<int>(found - mechanism.joints.begin());
}

void remove_friction(Mechanism& mechanism) {
  for (Joint& joint : mechanism.joints) {
    std::visit(
        [](auto& kind) {
          if constexpr (requires { kind.friction; }) kind.friction.reset();
        },
        joint.kind);
  }
}

}  // namespace gudgeon
