// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Do all loads have a value where a mechanism starts?
#pragma once

#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// Adds an error for every formula of a load that has no finite value at the assembled start, t = 0.
void check_start_loads(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics);

}  // namespace gudgeon
