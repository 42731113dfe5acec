// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Why loops cannot be closed, in words.
#pragma once

#include "gudgeon/system/loop_closer.h"

namespace gudgeon {

/// Throws ModelError, naming every joint and driver whose gap is left in a mechanism of ideal joints.
/// `clearance` names joints that were taken as ideal.
[[noreturn]] void throw_open_loop(const Mechanism& mechanism, const Tables& tables, const LoopCloser& closer);

/// Throws ModelError: the drivers prescribe more motions than the joints leave.
[[noreturn]] void throw_over_driven(const Mechanism& mechanism, int n_degrees_of_freedom);

}  // namespace gudgeon
