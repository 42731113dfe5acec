// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where a mechanism does not start as it was asked to.
#pragma once

#include "gudgeon/model/study.h"
#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// Remarks on start values that the mechanism starts without: one for every angle that could not even be a guess,
/// because joints or a body tied to it give it another; one for every rate that a driver holds at another; one for all
/// guesses together, the farthest ones named; one for journals that start off the middle of their bearings. Angles and
/// displacements that a driver prescribes are left to the check of drivers.
Diagnostics remark_start(const Mechanism& mechanism, const Assembly& assembly);

/// A remark when a study compares with the ideal mechanism and there is none that starts so.
Diagnostics remark_ideal_start(const Mechanism& mechanism, const Study& study);

}  // namespace gudgeon
