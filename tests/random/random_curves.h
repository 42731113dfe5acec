// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Curves through points by chance.
#pragma once

#include <string>

#include "tests/random/random_draw.h"
#include "tests/random/random_mechanism.h"

namespace gudgeon::random {

/// Values of that size over a channel, from `first` on over `range`; of any shape, with a step now and then.
SampledCurve draw_curve(Draw& draw, std::string over, double first, double range, double size);

/// One to three forces and torques over the coordinate that they push along: their works are integrals of the curves.
void add_curves(RandomModel& model, Draw& draw);

}  // namespace gudgeon::random
