// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where bodies start that nothing but clearance joints holds.
#pragma once

#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// Moves every loose body, and what hangs from it, to the start position and velocity given for it. Without them it
/// stays where the ideal joints have put it, journals in the middle of their bearings. So does one that pins in slots
/// tie to the frame; of several that they tie to each other the first one's place counts.
void place_loose_bodies(const Mechanism& mechanism, Assembly& assembly);

/// Whether every journal lies inside its bearing or slot, surfaces that just touch among them.
bool lies_within_play(const Mechanism& mechanism, const Assembly& assembly);

/// Throws ModelError when a journal starts beyond the surface of its bearing, deeper than it would rest there, a spring
/// starts without length or a load without a finite value, naming every such joint and load.
void require_clear_start(const Mechanism& mechanism, const Assembly& assembly);

}  // namespace gudgeon
