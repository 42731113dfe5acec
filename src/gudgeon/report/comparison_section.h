// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sections of the summary that set our values beside others: the ideal mechanism's and reference values.
// A section with nothing to say is an empty text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gudgeon/analysis/reference_values.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Channels of slider motion that render_ideal_errors compares; their values must have been read.
std::vector<std::string> find_ideal_channels(const RunRecord& run);

/// Error of the slider motion of every stage against the stage "ideal".
std::string render_ideal_errors(const RunRecord& run, bool color);

/// A row a reference quantity: reference, ours and their ratio for each stage.
std::string render_reference(const RunRecord& run, std::span<const ReferenceRow> reference, bool color);

}  // namespace gudgeon
