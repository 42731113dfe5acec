// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Starts in which journals press.
#pragma once

#include "gudgeon/system/system.h"

namespace gudgeon {

/// Whether contacts whose surfaces overlap at a start carry no more than the loads there press them with: with their
/// forces the bodies accelerate no more than without, by Σ m a² + I α². So a body may start where it rests.
bool rests_on_contacts(const System& system, const State& start);

}  // namespace gudgeon
