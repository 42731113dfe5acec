// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of a model file, one reader each. Every reader reports all that is wrong and returns what it could read.
#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gudgeon/io/table_reader.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

inline constexpr std::array<std::pair<std::string_view, NormalDirection>, 2> kNormalDirections{{
    {"gap_gradient", NormalDirection::gap_gradient},
    {"eccentricity", NormalDirection::eccentricity},
}};
inline constexpr std::array<std::pair<std::string_view, PressureDistribution>, 2> kPressureDistributions{{
    {"uniform", PressureDistribution::uniform},
    {"parabolic", PressureDistribution::parabolic},
}};
inline constexpr std::array<std::pair<std::string_view, WearDistribution>, 2> kWearDistributions{{
    {"spread", WearDistribution::spread},
    {"point", WearDistribution::point},
}};
inline constexpr std::array<std::pair<std::string_view, Integrator>, 3> kIntegrators{{
    {"automatic", Integrator::automatic},
    {"explicit", Integrator::explicit_pair},
    {"stiff", Integrator::stiff},
}};
inline constexpr std::array<std::pair<std::string_view, Stabilization>, 2> kStabilizations{{
    {"projection", Stabilization::projection},
    {"baumgarte", Stabilization::baumgarte},
}};
inline constexpr std::array<std::pair<std::string_view, Branch>, 2> kBranches{{
    {"left", Branch::left},
    {"right", Branch::right},
}};

/// [bodies.NAME]; the frame comes first, also when the file does not name it.
std::vector<Body> read_bodies(TableReader& root);
/// [materials.NAME]
std::vector<Material> read_materials(TableReader& root);
/// [contacts.NAME], materials put in by value.
std::vector<ContactProperties> read_contacts(TableReader& root, std::span<const Material> materials);
/// [joints.NAME], contacts put in by value.
std::vector<Joint> read_joints(TableReader& root, std::span<const ContactProperties> contacts);
/// [drivers.NAME]; a driver without start takes that of its body or joint.
std::vector<Driver> read_drivers(TableReader& root, const Mechanism& mechanism);
/// [loads.NAME]
std::vector<Load> read_loads(TableReader& root);
/// [study]
Study read_study(TableReader& root);

/// The two points of between = ["body.point", "body.point"]; what is wrong is reported.
void read_between(TableReader& table, Anchor& first, Anchor& second);
/// "crank_1.A" as body and point; nothing, and an error under the path, when it is not of that form.
Anchor read_anchor(const DocumentNode& node, const std::string& path, TableReader& table);

}  // namespace gudgeon
