// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One length that a mechanism's other lengths, and moments beside forces, are measured in.
#pragma once

#include "gudgeon/model/mechanism.h"

namespace gudgeon {

/// [m] The longest distance between two points of one moving body; where no body has two, between two of the frame; 1
/// where there are none at all.
double find_characteristic_length(const Mechanism& mechanism);

}  // namespace gudgeon
