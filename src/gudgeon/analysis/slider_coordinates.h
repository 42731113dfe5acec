// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sliders found from what was recorded: the bodies that move without turning.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Of bodies with statistics or values of an acceleration whose angle rate is zero or not recorded, the coordinates
/// that move, "slider.x" for one.
std::vector<std::string> find_slider_coordinates(const StageRecord& stage);

}  // namespace gudgeon
