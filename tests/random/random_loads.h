// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads by chance.
#pragma once

#include "tests/random/random_draw.h"
#include "tests/random/random_mechanism.h"

namespace gudgeon::random {

/// One to four loads of any kind but formulas that jump.
void add_loads(Mechanism& mechanism, Draw& draw);

/// A force that is one constant before an instant and another one after it.
void add_jump(RandomModel& model, Draw& draw);

}  // namespace gudgeon::random
