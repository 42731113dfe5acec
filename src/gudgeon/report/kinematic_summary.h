// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A kinematic analysis on one page of text.
#pragma once

#include <string>

#include "gudgeon/results/kinematic_record.h"

namespace gudgeon {

/// Ranges and peaks of bodies, slides, efforts and reactions, transmission angles, dead centres, branch changes.
/// Peaks are those of the samples; dead centres and transmission angles are located between them.
std::string render_kinematics(const KinematicRecord& record, bool color);

}  // namespace gudgeon
