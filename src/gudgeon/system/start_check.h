// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a run can start.
#pragma once

#include "gudgeon/model/study.h"
#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// What keeps a joint free whose friction has no solution, or more than one.
inline constexpr const char* kJamAdvice =
    "a smaller coefficient, a thinner pin, a longer guide or a force nearer to its line keep it free";

/// Throws ModelError when a mechanism cannot be run from an assembled start: a journal beyond its bearing, a spring
/// without length, a load without value, a singular position, accelerations that nothing determines.
void require_start(const Mechanism& mechanism, const Assembly& assembly);

/// The same of the ideal counterpart with friction, where the study compares with it.
void require_ideal_start(const Mechanism& mechanism, const Study& study);

}  // namespace gudgeon
