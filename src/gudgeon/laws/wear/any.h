// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every wear law. A new law is one more alternative here.
#pragma once

#include <variant>

#include "gudgeon/laws/wear/archard.h"
#include "gudgeon/laws/wear/archard_hardness.h"
#include "gudgeon/laws/wear/energy_wear.h"
#include "gudgeon/laws/wear/no_wear.h"
#include "gudgeon/laws/wear/running_in_depth.h"
#include "gudgeon/laws/wear/running_in_distance.h"

namespace gudgeon {

using AnyWear = std::variant<NoWear, Archard, ArchardHardness, RunningInDepth, RunningInDistance, EnergyWear>;

}  // namespace gudgeon
