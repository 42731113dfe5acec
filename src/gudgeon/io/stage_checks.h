// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What no stage of a run can be: values that damage, or another program, put into a file.
#pragma once

#include <span>
#include <string_view>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// FileError for a name that no stage has; others can be names of files.
void check_stage_name(std::string_view name);
/// FileError that names the first value of a stage without samples that cannot be.
void check_stage(const StageRecord& stage);
/// FileError when they are not finite or go back.
void check_times(std::span<const double> times);

}  // namespace gudgeon
