// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A driver by chance.
#pragma once

#include "tests/oracle/textbook.h"
#include "tests/random/random_draw.h"

namespace gudgeon::random {

/// Drives a pin or a guide of a mechanism in that pose: uniformly, swinging, or along a curve through points. The joint
/// is one that can move, if there is any. Whether it can.
bool add_driver(Mechanism& mechanism, const oracle::TextbookState& pose, Draw& draw);

}  // namespace gudgeon::random
