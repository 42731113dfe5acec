// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One stage into the groups of a run file. Under an Hdf5Session.
#pragma once

#include <cstdint>

#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Makes the group /stages/NAME; order counts the stages from 0.
void write_stage(const Hdf5Handle& stages, const StageRecord& stage, std::int64_t order);

}  // namespace gudgeon
