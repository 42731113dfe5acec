// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A run on one page of text.
#pragma once

#include <span>
#include <string>

#include "gudgeon/analysis/reference_values.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Stages, peaks, wear, contacts, error against the ideal mechanism, energy, and our values beside reference values.
/// Works on an outline too; the error against the ideal mechanism needs the values of find_ideal_channels (in
/// comparison_section.h) and is left out without them. color adds terminal escapes.
std::string render_summary(const RunRecord& run, std::span<const ReferenceRow> reference, bool color);

/// What a run file holds. Works on an outline; samples are counted for stages whose time was read.
std::string render_info(const RunRecord& outline, bool color);

}  // namespace gudgeon
