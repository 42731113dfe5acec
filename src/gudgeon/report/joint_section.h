// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sections of the summary about clearance joints. A section with nothing to say is an empty text.
#pragma once

#include <span>
#include <string>

#include "gudgeon/analysis/wear_summary.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Depth, volume and worn angles a stage and joint.
std::string render_wear(const RunRecord& run, bool color);

/// Onsets, time in contact and in flight, forces, a stage and joint.
std::string render_contacts(const RunRecord& run, bool color);

/// Where on the bearing: "54°", or on a slot "left -12.5 mm".
std::string render_place(const DeepestPoint& point, bool is_slot);
/// The worn part of a bearing or of a slot's sides.
std::string render_worn(const JointWearSummary& wear);
/// "32–120°, 246–328°"; ranges beyond the first few are counted.
std::string render_ranges(std::span<const AngleRange> ranges);
/// "left -20.0 to 12.5 mm, right …"
std::string render_side_ranges(std::span<const SideRange> ranges);

}  // namespace gudgeon
