// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads that depend on the state, in maximal coordinates: from the poses of the bodies alone.
#pragma once

#include <vector>

#include "tests/oracle/textbook.h"

namespace gudgeon::oracle {

/// All loads of the textbook's mechanism but the constant ones.
TextbookLoads find_loads(const Textbook& textbook, const TextbookState& state, double time);

}  // namespace gudgeon::oracle
