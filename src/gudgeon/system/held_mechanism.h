// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A mechanism whose drivers hold still.
#pragma once

#include "gudgeon/model/mechanism.h"

namespace gudgeon {

/// Ideal joints without friction, no start rates, every driver held where it is at t = 0. Throws ModelError as
/// assemble() does.
Mechanism hold_at_rest(const Mechanism& mechanism);

}  // namespace gudgeon
