// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Look-ups of recorded signals.
#include "gudgeon/report/figures/signals.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/analysis/ideal_comparison.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

Numbers Signals::find_time(const StageRecord& stage) {
  if (stage.time.empty()) return nullptr;
  Numbers& known = known_[{stage.name, "\ntime"}];  // no channel has such a name
  if (!known) known = make_numbers(stage.time);
  return known;
}

Numbers Signals::find_values_of(const StageRecord& stage, const std::string& channel) {
  const std::vector<double>* values = find_values(stage, channel);
  if (values == nullptr || values->empty() || values->size() != stage.time.size()) return nullptr;
  Numbers& known = known_[{stage.name, channel}];
  if (!known) known = make_numbers(*values);
  return known;
}

Numbers Signals::find_error_of(const StageRecord& stage, const std::string& channel) {
  const StageRecord* ideal = find_stage(*run_, kIdealStageName);
  if (ideal == nullptr || !find_values_of(stage, channel) || !find_values_of(*ideal, channel)) return nullptr;
  Numbers& known = known_[{stage.name, channel + "\nerror"}];
  try {
    if (!known) known = make_numbers(find_error_series(stage, *ideal, channel));
  } catch (const NumericalError&) {
    return nullptr;  // sampled at other times
  }
  return known;
}

std::size_t find_cycle_samples(const StageRecord& stage) {
  if (stage.time.size() < 2 || !(stage.cycle_time > 0.0)) return 0;
  // The median step: a stage that stopped has one odd sample at its end.
  const double step = stage.time[stage.time.size() / 2] - stage.time[stage.time.size() / 2 - 1];
  return step > 0.0 ? static_cast<std::size_t>(std::llround(stage.cycle_time / step)) : 0;
}

int find_stage_color(const RunRecord& run, const std::string& stage) {
  int color = 0;
  for (const StageRecord& one : run.stages) {
    if (one.name != kIdealStageName) ++color;
    if (one.name == stage) return stage == kIdealStageName ? 0 : color;
  }
  return 0;
}

FigureCurve make_stage_curve(const RunRecord& run, const StageRecord& stage, Numbers x, Numbers y) {
  FigureCurve curve;
  curve.name = label_stage(stage.name);
  curve.group = stage.name;
  curve.x = std::move(x);
  curve.y = std::move(y);
  curve.color = find_stage_color(run, stage.name);
  return curve;
}

}  // namespace gudgeon
