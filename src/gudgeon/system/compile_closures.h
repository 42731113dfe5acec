// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rows and terms of all closures, before their matrix entries have slots.
#pragma once

#include "gudgeon/system/tables.h"

namespace gudgeon {

/// Fills tables.closures and tables.closure_terms, all but their slots. `active` has one entry a closure.
void compile_closures(const Mechanism& mechanism, const Topology& topology, const ActiveRows& active, Tables& tables);

/// Counts, drivers and closures alone: enough to assemble a mechanism and to count its rows, not to move it.
Tables compile_loops(const Mechanism& mechanism, const Topology& topology);

}  // namespace gudgeon
