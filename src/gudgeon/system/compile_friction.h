// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Ideal joints with friction, put into the tables.
#pragma once

#include "gudgeon/system/tables.h"

namespace gudgeon {

/// Adds the ideal joints with friction, their points and their bristles; all other tables but idle turns are complete.
void compile_friction(const Mechanism& mechanism, const Topology& topology, Tables& tables);

}  // namespace gudgeon
