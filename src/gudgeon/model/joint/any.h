// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every type of joint. A new one is one more alternative here.
#pragma once

#include <string_view>
#include <utility>
#include <variant>

#include "gudgeon/model/joint/pin_in_slot.h"
#include "gudgeon/model/joint/pin_in_slot_clearance.h"
#include "gudgeon/model/joint/prismatic.h"
#include "gudgeon/model/joint/prismatic_clearance.h"
#include "gudgeon/model/joint/revolute.h"
#include "gudgeon/model/joint/revolute_clearance.h"
#include "gudgeon/model/joint/rigid.h"

namespace gudgeon {

using AnyJoint =
    std::variant<Revolute, Prismatic, PinInSlot, Rigid, RevoluteClearance, PrismaticClearance, PinInSlotClearance>;

/// A joint whose surfaces touch only now and then.
template <class Kind>
concept ClearanceJoint = requires(const Kind kind) {
  kind.contact;
};

/// Friction of an ideal joint; nullptr for one without, and for a clearance joint.
inline const JointFriction* find_friction(const AnyJoint& joint) {
  return std::visit(
      []<class Kind>(const Kind& kind) -> const JointFriction* {
        if constexpr (requires { kind.friction; }) {
          return kind.friction ? &*kind.friction : nullptr;
        } else {
          return nullptr;
        }
      },
      joint);
}

/// Contact properties of a clearance joint; nullptr for an ideal joint.
inline const ContactProperties* find_contact(const AnyJoint& joint) {
  return std::visit(
      []<class Kind>(const Kind& kind) -> const ContactProperties* {
        if constexpr (ClearanceJoint<Kind>) {
          return &kind.contact;
        } else {
          return nullptr;
        }
      },
      joint);
}

/// c [m] of a clearance joint; zero for an ideal joint.
inline double find_clearance(const AnyJoint& joint) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        if constexpr (ClearanceJoint<Kind>) {
          return kind.play();
        } else {
          return 0.0;
        }
      },
      joint);
}

inline bool has_clearance(const AnyJoint& joint) { return find_contact(joint) != nullptr; }

/// The type of a joint as the model file names it, "revolute_clearance".
inline std::string_view joint_type(const AnyJoint& joint) {
  return std::visit([]<class Kind>(const Kind&) { return Kind::kType; }, joint);
}

/// The two points a joint connects; for a clearance joint the bearing comes first.
inline std::pair<const Anchor&, const Anchor&> anchors(const AnyJoint& joint) {
  return std::visit(
      []<class Kind>(const Kind& kind) -> std::pair<const Anchor&, const Anchor&> {
        if constexpr (ClearanceJoint<Kind>) {
          return {kind.bearing, kind.journal};
        } else {
          return {kind.first, kind.second};
        }
      },
      joint);
}

}  // namespace gudgeon
