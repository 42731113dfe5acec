// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How far a motion with clearance is from that of the ideal mechanism.
#pragma once

#include <string_view>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Two sample times are the same when they differ by less than this part of a cycle: rounding of k Δt over thousands
/// of cycles stays below, the distance between samples is far above.
inline constexpr double kSameTimeFraction = 1e-9;

/// Error of a channel against the ideal mechanism, in the channel's unit.
struct IdealError {
  double largest = 0.0;       ///< signed value of largest magnitude
  double largest_time = 0.0;  ///< [s]
  double rms = 0.0;           ///< over time
};

/// value − ideal value at each of the stage's samples. A stage that stopped early is compared as far as it came.
/// NumericalError when a channel is missing, was not read, or the samples are not at the same times.
std::vector<double> find_error_series(const StageRecord& stage, const StageRecord& ideal, std::string_view channel);

IdealError find_ideal_error(const StageRecord& stage, const StageRecord& ideal, std::string_view channel);

}  // namespace gudgeon
