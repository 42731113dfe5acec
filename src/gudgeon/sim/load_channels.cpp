// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One list a kind of load.
#include "gudgeon/sim/load_channels.h"

namespace gudgeon {

namespace {

using Effect = LoadEffect;

constexpr LoadChannel kConstantForce[] = {
    {"x_force", "F_x", "N", "Force on the load's point, along x", [](const Effect& e) { return e.force.x; }},
    {"y_force", "F_y", "N", "Force on the load's point, along y", [](const Effect& e) { return e.force.y; }},
};

constexpr LoadChannel kConstantTorque[] = {
    {"torque", "M", "N m", "Torque on the load's body", [](const Effect& e) { return e.torque; }},
};

constexpr LoadChannel kVariableForce[] = {
    {"x_force", "F_x", "N", "Force on the load's point, along the frame's x axis",
     [](const Effect& e) { return e.force.x; }},
    {"y_force", "F_y", "N", "Force on the load's point, along the frame's y axis",
     [](const Effect& e) { return e.force.y; }},
    {"force", "|F|", "N", "Magnitude of the force", [](const Effect& e) { return norm(e.force); }},
    {"power", "P", "W", "Power that the force delivers to the mechanism", [](const Effect& e) { return e.work_power; }},
};

constexpr LoadChannel kVariableTorque[] = {
    {"torque", "M", "N m", "Torque on the load's body", [](const Effect& e) { return e.torque; }},
    {"power", "P", "W", "Power that the torque delivers to the mechanism",
     [](const Effect& e) { return e.work_power; }},
};

constexpr LoadChannel kSpring[] = {
    {"length", "L", "m", "Distance of the spring's points", [](const Effect& e) { return e.length; }},
    {"force", "F", "N", "Pull of spring and damper, > 0 draws the points together",
     [](const Effect& e) { return e.pull; }},
};

constexpr LoadChannel kTorsionSpring[] = {
    {"twist", "θ", "rad", "Angle of the second body against the first", [](const Effect& e) { return e.twist; }},
    {"torque", "M", "N m", "Torque on the second body", [](const Effect& e) { return e.torque; }},
};

constexpr LoadChannel kBushing[] = {
    {"x_offset", "r_x", "m", "Second point from the first, along the first body's x axis",
     [](const Effect& e) { return e.offset.x; }},
    {"y_offset", "r_y", "m", "Second point from the first, along the first body's y axis",
     [](const Effect& e) { return e.offset.y; }},
    {"twist", "θ", "rad", "Angle of the second body against the first", [](const Effect& e) { return e.twist; }},
    {"x_force", "F_x", "N", "Force on the second point, along the frame's x axis",
     [](const Effect& e) { return e.force.x; }},
    {"y_force", "F_y", "N", "Force on the second point, along the frame's y axis",
     [](const Effect& e) { return e.force.y; }},
    {"force", "|F|", "N", "Magnitude of the force", [](const Effect& e) { return norm(e.force); }},
    {"torque", "M", "N m", "Torque on the second body", [](const Effect& e) { return e.torque; }},
};

std::span<const LoadChannel> list(const ConstantForce&) { return kConstantForce; }
std::span<const LoadChannel> list(const ConstantTorque&) { return kConstantTorque; }
std::span<const LoadChannel> list(const VariableForce&) { return kVariableForce; }
std::span<const LoadChannel> list(const VariableTorque&) { return kVariableTorque; }
std::span<const LoadChannel> list(const Spring&) { return kSpring; }
std::span<const LoadChannel> list(const TorsionSpring&) { return kTorsionSpring; }
std::span<const LoadChannel> list(const Bushing&) { return kBushing; }

}  // namespace

std::span<const LoadChannel> list_load_channels(const AnyLoad& kind) {
  return std::visit([](const auto& load) { return list(load); }, kind);
}

}  // namespace gudgeon
