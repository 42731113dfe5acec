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

/// The two points coincide; the bodies turn freely.
struct Revolute {
  Anchor first;
  Anchor second;
};

/// The second point slides along a line through the first; the bodies keep their relative angle.
struct Prismatic {
  Anchor first;
  Anchor second;
  double direction = 0.0;                    ///< [rad] of the line, in the first body's axes
  double relative_angle = 0.0;               ///< θ_second − θ_first [rad]
  std::optional<double> start_displacement;  ///< [m] along the line, a guess
  std::optional<double> start_speed;         ///< [m/s]
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

using AnyJoint = std::variant<Revolute, Prismatic, Rigid, RevoluteClearance>;

struct Joint {
  std::string name;
  AnyJoint kind;
};

/// The two points a joint connects; for a clearance joint the bearing comes first.
inline std::pair<const Anchor&, const Anchor&> anchors(const AnyJoint& joint) {
  return std::visit(
      []<class Kind>(const Kind& kind) -> std::pair<const Anchor&, const Anchor&> {
        if constexpr (std::same_as<Kind, RevoluteClearance>) {
          return {kind.bearing, kind.journal};
        } else {
          return {kind.first, kind.second};
        }
      },
      joint);
}

}  // namespace gudgeon
