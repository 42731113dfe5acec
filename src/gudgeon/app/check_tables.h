// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What `gudgeon check` says about a sound model, as text.
#pragma once

#include <string>

#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"
#include "gudgeon/system/assembly.h"
#include "gudgeon/system/mobility.h"

namespace gudgeon {

/// Bodies, coordinates, rows and degrees of freedom, and what the program makes of them.
std::string render_counts(const Mechanism& mechanism, const Mobility& mobility, bool color);
/// Each body's start position, and how far its angle is from the guess.
std::string render_start(const Mechanism& mechanism, const Assembly& assembly, bool color);
/// To which side each loop folds.
std::string render_loops(const Assembly& assembly, bool color);
/// How long a cycle takes.
std::string render_cycle(const Study& study);

}  // namespace gudgeon
