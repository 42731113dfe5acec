// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sliders found from what was recorded: the bodies that move without turning.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Names of the bodies with statistics or values of an acceleration whose angle rate is zero or not recorded.
std::vector<std::string> find_translating_bodies(const StageRecord& stage);

/// Of a translating body, the axes it moves along: "x", "y" or both.
std::vector<std::string> find_moving_axes(const StageRecord& stage, const std::string& body);

}  // namespace gudgeon
