// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One stage from the groups of a run file. Under an Hdf5Session.
#pragma once

#include <string>

#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// The stage without time and values.
StageRecord read_stage_outline(const Hdf5Handle& stages, const std::string& name);

/// Fills time, and the values of channel k.
void read_stage_time(const Hdf5Handle& stages, StageRecord& stage);
void read_stage_values(const Hdf5Handle& stages, StageRecord& stage, std::size_t k);

}  // namespace gudgeon
