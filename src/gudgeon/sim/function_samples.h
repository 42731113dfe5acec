// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The formulas and curves of a model, evaluated to be looked at.
#pragma once

#include <vector>

#include "gudgeon/model/study.h"
#include "gudgeon/results/function_samples.h"
#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// Every formula and curve of loads and drivers: curves over their points and a little beyond, formulas of the time
/// over the study. A formula of the mechanism's position and speed is shown over each channel that it uses, half a
/// turn, one characteristic length, or the speeds that go with these in a cycle, to either side of the assembled start,
/// with what else it depends on at the start and half as far to either side. Motions come with their acceleration.
std::vector<FunctionSamples> sample_functions(const Mechanism& mechanism, const Study& study, const Assembly& assembly);

}  // namespace gudgeon
