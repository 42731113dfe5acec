// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From the loads of a mechanism to their tables.
#pragma once

#include "gudgeon/system/tables.h"

namespace gudgeon {

/// Writes tables.loads and adds the points that they need to tables.points. Equations are numbered already.
void compile_loads(const Mechanism& mechanism, const Topology& topology, Tables& tables);

}  // namespace gudgeon
