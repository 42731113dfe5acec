// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How long one cycle of a study lasts.
#pragma once

#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

/// [s] One cycle when the study says nothing and no driver turns.
inline constexpr double kDefaultCycleTime = 1.0;

/// The driver whose turn is one cycle: the study's cycle_driver; without one and without a cycle_time the first driver
/// that turns a body uniformly. nullptr when the cycle is a time, or when the named driver does not exist, drives no
/// angle, or has a motion of its own.
const Driver* find_cycle_driver(const Mechanism& mechanism, const Study& study);

/// [s] One turn of the cycle driver, 2π/|speed|; without one the study's cycle_time, or kDefaultCycleTime when that is
/// not given either. Infinite for a cycle driver at rest, which check() refuses.
double find_cycle_time(const Mechanism& mechanism, const Study& study);

}  // namespace gudgeon
