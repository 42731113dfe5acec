// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Figures of what a model's loads and drivers were given.
#pragma once

#include <span>
#include <vector>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/results/function_samples.h"

namespace gudgeon {

/// One figure a formula or curve and what it runs over, with the points of a curve; topic "given". Samples of one
/// formula over the same, with what else it depends on held elsewhere, share a figure; they have to follow each other.
std::vector<Figure> make_function_figures(std::span<const FunctionSamples> functions);

}  // namespace gudgeon
