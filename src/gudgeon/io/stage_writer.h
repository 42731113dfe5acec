// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One stage into the groups of a run file. Under an Hdf5Session.
#pragma once

#include <cstddef>
#include <string>

#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/results/sample_block.h"

namespace gudgeon {

/// Makes the group /stages/NAME, last in order, with all that the record holds.
void write_stage(const Hdf5Handle& stages, const StageRecord& stage);

/// The same for a stage that comes in blocks: first begin_stage with the first one, which is also the size of chunks,
/// then extend_stage with each other, at last end_stage with the record, which holds the samples since the last block.
void begin_stage(const Hdf5Handle& stages, const SampleBlock& block);
void extend_stage(const Hdf5Handle& stages, const SampleBlock& block);
void end_stage(const Hdf5Handle& stages, const StageRecord& stage);
/// Leaves of a stage that was ended nothing but its first samples: it can be extended and ended again.
void reopen_stage(const Hdf5Handle& stages, const std::string& name, std::size_t n_samples);

}  // namespace gudgeon
