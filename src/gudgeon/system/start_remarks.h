// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where a mechanism does not start as it was asked to.
#pragma once

#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// A remark for every body whose start angle could not even be a guess, because joints or a body tied to it give it
/// another. Those that a driver turns are left to the check of drivers.
Diagnostics remark_held_angles(const Mechanism& mechanism, const Assembly& assembly);

}  // namespace gudgeon
