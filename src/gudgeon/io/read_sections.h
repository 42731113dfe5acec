// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of a model file, one reader each. Every reader reports all that is wrong and returns what it could read.
#pragma once

#include <span>
#include <vector>

#include "gudgeon/io/table_reader.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

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

}  // namespace gudgeon
