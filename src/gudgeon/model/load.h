// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads: forces and torques, constant or variable, springs and dampers.
#pragma once

#include <string>
#include <variant>

#include "gudgeon/base/vec2.h"
#include "gudgeon/model/body.h"
#include "gudgeon/model/field.h"
#include "gudgeon/model/function.h"
#include "gudgeon/model/joint/anchor.h"

namespace gudgeon {

/// A coefficient of a spring or damper.
constexpr FieldTraits coefficient(Dimension dimension, std::string_view symbol, std::string_view meaning) {
  return {.dimension = dimension, .symbol = symbol, .range = kNotNegative, .code = "E-MODEL-052", .meaning = meaning};
}

/// A constant force, in the frame's axes, on a point of a body.
struct ConstantForce {
  Anchor point;
  Vec2 force;  ///< [N]

  static constexpr std::string_view kType = "force";
  static constexpr auto kFields = std::tuple{
      field("point", &ConstantForce::point, {.required = true, .meaning = "of the body"}),
      field("force", &ConstantForce::force,
            {.required = true, .dimension = dimension::kForce, .meaning = "x and y, in the frame's axes"}),
  };
};

/// A constant torque on a body.
struct ConstantTorque {
  std::string body;
  double torque = 0.0;  ///< [N m], counter-clockwise

  static constexpr std::string_view kType = "torque";
  static constexpr auto kFields = std::tuple{
      field("body", &ConstantTorque::body, {.required = true, .names = Names::body, .meaning = "the body"}),
      field("torque", &ConstantTorque::torque,
            {.required = true, .dimension = dimension::kTorque, .meaning = "counter-clockwise"}),
  };
};

/// A force on a point of a body that depends on time or on the mechanism's position and speed.
struct VariableForce {
  Anchor point;
  Function x = 0.0;  ///< [N] along the x axis of `axes`
  Function y = 0.0;  ///< [N] along its y axis
  std::string axes = kFrameName;

  static constexpr std::string_view kType = "force";
  static constexpr std::string_view kMeaning = "a force on a point of a body; the type of a load with a point";
  static constexpr auto kFields = std::tuple{
      field("point", &VariableForce::point, {.required = true, .meaning = "of the body"}),
      field("axes", &VariableForce::axes, {.names = Names::body, .meaning = "the body in whose axes x and y are"}),
      field("force", &VariableForce::x, &VariableForce::y,
            {.required = true, .dimension = dimension::kForce, .meaning = "x and y"}),
  };
};

/// A torque on a body, and its opposite on another.
struct VariableTorque {
  std::string body;
  std::string against = kFrameName;
  Function torque = 0.0;  ///< [N m] on `body`, counter-clockwise

  static constexpr std::string_view kType = "torque";
  static constexpr std::string_view kMeaning = "a torque on a body; the type of a load with a body";
  static constexpr auto kFields = std::tuple{
      field("body", &VariableTorque::body, {.required = true, .names = Names::body, .meaning = "the body"}),
      field("against", &VariableTorque::against, {.names = Names::body, .meaning = "the body that feels the opposite"}),
      field("torque", &VariableTorque::torque,
            {.required = true, .dimension = dimension::kTorque, .meaning = "counter-clockwise"}),
  };
};

/// Spring and damper along the line between two points: pull F = k (L − L₀) + d L̇ on both, towards each other.
struct Spring {
  Anchor first;
  Anchor second;
  double stiffness = 0.0;    ///< k [N/m]
  double damping = 0.0;      ///< d [N s/m]
  double free_length = 0.0;  ///< L₀ [m]

  static constexpr std::string_view kType = "spring";
  static constexpr std::string_view kMeaning = "a spring and damper along the line between two points";
  static constexpr auto kFields = std::tuple{
      field("between", &Spring::first, &Spring::second, {.required = true, .meaning = "the two points"}),
      field("stiffness", &Spring::stiffness, coefficient(dimension::kStiffness, "k", "of the spring")),
      field("damping", &Spring::damping, coefficient(dimension::kDamping, "d", "of the damper")),
      field("free_length", &Spring::free_length,
            {.dimension = dimension::kLength,
             .symbol = "L₀",
             .range = kNotNegative,
             .code = "E-MODEL-052",
             .absent = "needed with a stiffness",
             .meaning = "at which the spring does not pull"}),
  };
};

/// Torsion spring and damper: torque M = −k (θ − θ₀) − d θ̇ on the second body and −M on the first, θ = θ_second −
/// θ_first.
struct TorsionSpring {
  std::string first;
  std::string second;
  double stiffness = 0.0;   ///< k [N m/rad]
  double damping = 0.0;     ///< d [N m s/rad]
  double free_angle = 0.0;  ///< θ₀ [rad]

  static constexpr std::string_view kType = "torsion_spring";
  static constexpr std::string_view kMeaning = "a torsion spring and damper between two bodies";
  static constexpr auto kFields = std::tuple{
      field("between", &TorsionSpring::first, &TorsionSpring::second,
            {.required = true, .names = Names::body, .meaning = "the two bodies"}),
      field("stiffness", &TorsionSpring::stiffness, coefficient(dimension::kAngularStiffness, "k", "of the spring")),
      field("damping", &TorsionSpring::damping, coefficient(dimension::kAngularDamping, "d", "of the damper")),
      field("free_angle", &TorsionSpring::free_angle,
            {.dimension = dimension::kAngle,
             .symbol = "θ₀",
             .meaning = "of the second body against the first at which the spring does not turn"}),
  };
};

/// An elastic joint: with r the second point against the first, in the first body's axes, and θ = θ_second − θ_first,
/// the second body feels F = −k r − d ṙ (each component its own) at its point and M = −k_θ (θ − θ₀) − d_θ θ̇. ṙ is what
/// an observer on the first body sees.
struct Bushing {
  Anchor first;
  Anchor second;
  Vec2 stiffness;                  ///< k [N/m] along the first body's x and y
  Vec2 damping;                    ///< d [N s/m]
  double angular_stiffness = 0.0;  ///< k_θ [N m/rad]
  double angular_damping = 0.0;    ///< d_θ [N m s/rad]
  double free_angle = 0.0;         ///< θ₀ [rad]

  static constexpr std::string_view kType = "bushing";
  static constexpr std::string_view kMeaning =
      "an elastic joint: springs and dampers along both axes of the first body, and in turning";
  static constexpr auto kFields = std::tuple{
      field("between", &Bushing::first, &Bushing::second, {.required = true, .meaning = "the two points"}),
      field("stiffness", &Bushing::stiffness,
            coefficient(dimension::kStiffness, "k", "along the first body's x and y")),
      field("damping", &Bushing::damping, coefficient(dimension::kDamping, "d", "along the first body's x and y")),
      field("angular_stiffness", &Bushing::angular_stiffness,
            coefficient(dimension::kAngularStiffness, "k_θ", "in turning")),
      field("angular_damping", &Bushing::angular_damping, coefficient(dimension::kAngularDamping, "d_θ", "in turning")),
      field("free_angle", &Bushing::free_angle,
            {.dimension = dimension::kAngle,
             .symbol = "θ₀",
             .meaning = "of the second body against the first at which the bushing does not turn"}),
  };
};

using AnyLoad =
    std::variant<ConstantForce, ConstantTorque, VariableForce, VariableTorque, Spring, TorsionSpring, Bushing>;

/// One that a model file may hold; a constant force or torque is written as a variable one.
template <class Kind>
concept FileLoad = requires {
  Kind::kMeaning;
};

/// The type of a load as the model file names it, "torsion_spring".
inline std::string_view load_type(const AnyLoad& load) {
  return std::visit([]<class Kind>(const Kind&) { return Kind::kType; }, load);
}

struct Load {
  std::string name;
  AnyLoad kind;
};

}  // namespace gudgeon
