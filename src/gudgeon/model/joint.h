// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Joints between named points of two bodies.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "gudgeon/laws/friction/any.h"
#include "gudgeon/laws/normal/any.h"
#include "gudgeon/laws/wear/any.h"

namespace gudgeon {

/// A point of a body, written "crank_1.A" in the model file.
struct Anchor {
  std::string body;
  std::string point;
};

/// Friction in an ideal joint, by a law and what the force that the joint carries acts on (docs/theory/friction.md).
struct JointFriction {
  AnyFriction law;
  double pin_radius = 0.0;    ///< r [m] of the pin of a revolute joint, or of a pin in a slot
  double guide_length = 0.0;  ///< L [m] over which block and guide touch, about the second point; 0: moments do not rub
  double guide_height = 0.0;  ///< h [m] of the block across its guide
};

/// The two points coincide; the bodies turn freely.
struct Revolute {
  Anchor first;
  Anchor second;
  std::optional<JointFriction> friction = std::nullopt;
};

/// The second point slides along a line through the first; the bodies keep their relative angle.
struct Prismatic {
  Anchor first;
  Anchor second;
  double direction = 0.0;                    ///< [rad] of the line, in the first body's axes
  double relative_angle = 0.0;               ///< θ_second − θ_first [rad]
  std::optional<double> start_displacement;  ///< [m] along the line, a guess
  std::optional<double> start_speed;         ///< [m/s]
  std::optional<JointFriction> friction = std::nullopt;
};

/// The second point stays on a line through the first; the bodies turn freely.
struct PinInSlot {
  Anchor first;
  Anchor second;
  double direction = 0.0;  ///< [rad] of the line, in the first body's axes
  std::optional<JointFriction> friction = std::nullopt;
};

/// The two points coincide and the bodies keep their relative angle.
struct Rigid {
  Anchor first;
  Anchor second;
  double relative_angle = 0.0;  ///< θ_second − θ_first [rad]
};

struct Material {
  std::string name;
  double young_modulus = 0.0;  ///< E [Pa]
  double poisson_ratio = 0.0;  ///< ν [1]
};

/// Along which direction a worn surface presses.
enum class NormalDirection {
  gap_gradient,  ///< the normal of the worn surface: elastic contact conserves energy (default)
  eccentricity,  ///< the line of centres, as in the paper
};

/// How the pressure of a contact is spread over its arc; a is half the arc, x the place on it from its middle.
enum class PressureDistribution {
  uniform,    ///< p = F/(w L) everywhere, as in the paper (default)
  parabolic,  ///< 3/2 of that at the middle, p ∝ 1 − (x/a)², as between bodies that fit closely
};

/// How bearing and journal surfaces act on each other: a [contacts.NAME] table of the model file.
struct ContactProperties {
  std::string name;
  Material bearing_material;
  Material journal_material;
  AnyNormalForce normal_force;
  AnyFriction friction;
  AnyWear bearing_wear = NoWear{};
  AnyWear journal_wear = NoWear{};
  double onset_speed_floor = 1e-3;  ///< [m/s] least onset speed the damping is scaled with
  NormalDirection normal_direction = NormalDirection::gap_gradient;
  PressureDistribution pressure = PressureDistribution::uniform;
};

/// A revolute joint with clearance: the journal of one body moves and hits inside the bearing of the other.
struct RevoluteClearance {
  Anchor bearing;
  Anchor journal;
  double bearing_radius = 0.0;    ///< R_i [m]
  double radial_clearance = 0.0;  ///< c = R_i − R_j [m]
  double width = 0.0;             ///< w [m] along the axis
  ContactProperties contact;
};

/// A guide with clearance: a block, the journal, slides, tilts and knocks between the two sides of a slot, the bearing.
/// Each of its four rounded corners touches the side it faces. Without clearance it is a Prismatic.
struct PrismaticClearance {
  Anchor bearing;               ///< the middle of the slot
  Anchor journal;               ///< the middle of the block
  double direction = 0.0;       ///< [rad] of the slot, in the bearing's body
  double relative_angle = 0.0;  ///< [rad] θ_journal − θ_bearing at which the block lies along the slot
  double bearing_length = 0.0;  ///< [m] of the slot
  double journal_length = 0.0;  ///< [m] of the block, along the slot
  double journal_height = 0.0;  ///< [m] of the block, across the slot
  double corner_radius = 0.0;   ///< R_j [m] of the block's corners
  double clearance = 0.0;       ///< c [m] on either side: the slot is journal_height + 2 c wide
  double width = 0.0;           ///< w [m] along the axis
  ContactProperties contact;
};

/// A pin, the journal, in a slot that is wider than it, the bearing. Without clearance it is a PinInSlot.
struct PinInSlotClearance {
  Anchor bearing;               ///< the middle of the slot
  Anchor journal;               ///< the centre of the pin
  double direction = 0.0;       ///< [rad] of the slot, in the bearing's body
  double bearing_length = 0.0;  ///< [m] of the slot
  double journal_radius = 0.0;  ///< R_j [m]
  double clearance = 0.0;       ///< c [m] on either side: the slot is 2 (R_j + c) wide
  double width = 0.0;           ///< w [m] along the axis
  ContactProperties contact;
};

using AnyJoint =
    std::variant<Revolute, Prismatic, PinInSlot, Rigid, RevoluteClearance, PrismaticClearance, PinInSlotClearance>;

/// One of the two ways to assemble the loop that a joint closes: to which side it folds, see docs/theory/kinematics.md.
enum class Branch { left, right };

struct Joint {
  std::string name;
  AnyJoint kind;
  std::optional<Branch> branch = std::nullopt;  ///< demanded of the start; else the start angles choose
};

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
  if (const auto* revolute = std::get_if<RevoluteClearance>(&joint)) return revolute->radial_clearance;
  if (const auto* guide = std::get_if<PrismaticClearance>(&joint)) return guide->clearance;
  if (const auto* slot = std::get_if<PinInSlotClearance>(&joint)) return slot->clearance;
  return 0.0;
}

inline bool has_clearance(const AnyJoint& joint) { return find_contact(joint) != nullptr; }

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
