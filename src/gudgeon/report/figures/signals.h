// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Recorded signals of a run as curves of figures.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

inline constexpr const char* kIdealStageName = "ideal";

/// Hands out a run's signals; the same signal is the same Numbers, however many figures show it.
class Signals {
 public:
  /// The run must outlive this.
  explicit Signals(const RunRecord& run) : run_(&run) {}

  [[nodiscard]] const RunRecord& run() const { return *run_; }
  /// Times of a stage's samples; null when none were read.
  Numbers find_time(const StageRecord& stage);
  /// A channel's values; null when it was not recorded or not read.
  Numbers find_values_of(const StageRecord& stage, const std::string& channel);
  /// value − ideal value; null when the two cannot be compared.
  Numbers find_error_of(const StageRecord& stage, const std::string& channel);

 private:
  const RunRecord* run_;
  std::map<std::pair<std::string, std::string>, Numbers> known_;  ///< by stage and channel
};

/// Samples a cycle of a stage; 0 when it cannot be told.
std::size_t find_cycle_samples(const StageRecord& stage);

/// Index into the palette: 0 for the ideal mechanism, then the stages with clearance one after the other.
int find_stage_color(const RunRecord& run, const std::string& stage);

/// A curve of a stage, coloured and named after it.
FigureCurve make_stage_curve(const RunRecord& run, const StageRecord& stage, Numbers x, Numbers y);

}  // namespace gudgeon
