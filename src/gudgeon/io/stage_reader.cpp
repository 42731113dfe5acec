// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Channels, statistics, events, wear, energy and solver work of a stage, checked against each other.
#include "gudgeon/io/stage_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/run_tables.h"
#include "gudgeon/io/stage_channels.h"
#include "gudgeon/io/stage_checks.h"

namespace gudgeon {

namespace {

int read_cycles(const Hdf5Handle& node) {
  const std::int64_t cycles = read_count(node, "cycles");
  if (cycles >= 0 && cycles <= std::numeric_limits<int>::max()) return static_cast<int>(cycles);
  throw FileError(fmt::format("'cycles' is {}, which no run has", cycles));
}

template <class Record, class Fields>
void read_reals(const Hdf5Handle& node, Record& record, const Fields& fields) {
  for (const auto& field : fields) {
    if (field.may_lack && !has_value(node, field.name)) continue;
    record.*field.member = read_real(node, field.name);
  }
}

StageStatus read_status(const Hdf5Handle& node) {
  const std::string text = read_text(node, "status");
  const auto found = std::ranges::find(kStatusNames, text, [](const StatusName& s) { return std::string(s.name); });
  if (found == kStatusNames.end()) throw FileError(fmt::format("status '{}' is not known", text));
  return found->status;
}

void read_statistics(const Hdf5Handle& node, StageRecord& stage) {
  read_table(node, "statistics", kStatisticsShape, [&](const void* bytes) {
    const auto& row = *static_cast<const StatisticsRow*>(bytes);
    const std::string channel = row.channel == nullptr ? "" : row.channel;
    stage.statistics.push_back(
        {channel, row.minimum, row.minimum_time, row.maximum, row.maximum_time, row.mean, row.rms});
  });
}

void read_wear(const Hdf5Handle& node, StageRecord& stage) {
  const Hdf5Handle group = open_group(node, "wear");
  for (const std::string& name : find_children(group)) {
    const Hdf5Handle joint = open_group(group, name);
    JointWear& wear = stage.wear.emplace_back();
    wear.joint = name;
    read_reals(joint, wear, kWearReals);
    // Files of before slots have it in the radii.
    if (!has_value(joint, "clearance")) wear.clearance = wear.bearing_radius - wear.journal_radius;
    for (const auto& field : kWearSeries) wear.*field.member = read_series(joint, field.name);
  }
}

void read_events(const Hdf5Handle& node, StageRecord& stage) {
  read_table(node, "events", kEventShape,
             [&](const void* bytes) { stage.events.push_back(*static_cast<const ContactEvent*>(bytes)); });
}

void read_solver(const Hdf5Handle& node, SolverStatistics& solver) {
  const Hdf5Handle group = open_group(node, "solver");
  for (const auto& field : kSolverCounts) solver.*field.member = read_count(group, field.name);
  read_reals(group, solver, kSolverReals);
}

}  // namespace

StageRecord read_stage_outline(const Hdf5Handle& stages, const std::string& name) {
  const Hdf5Handle node = open_group(stages, name);
  StageRecord stage;
  stage.name = name;
  stage.status = read_status(node);
  stage.message = read_text(node, "message");
  stage.cycles = read_cycles(node);
  read_reals(node, stage, kStageReals);
  stage.channels = read_channel_list(node);
  stage.values.resize(stage.channels.size());
  read_statistics(node, stage);
  read_wear(node, stage);
  read_events(node, stage);
  read_reals(open_group(node, "energy"), stage.energy, kEnergyReals);
  read_solver(node, stage.solver);
  check_stage(stage);
  return stage;
}

StageSamples::StageSamples(const Hdf5Handle& stages, const std::string& name)
    : stage_(open_group(stages, name)), channels_(stage_) {}

void StageSamples::read_time(StageRecord& stage) const {
  stage.time = read_times(stage_);
  check_times(stage.time);
}

void StageSamples::read_values(StageRecord& stage, std::size_t k) const {
  const std::string& name = stage.channels[k].name;
  std::vector<double> values = channels_.read(name);
  if (values.size() != stage.time.size()) {
    throw FileError(
        fmt::format("channel '{}' has {} samples where time has {}", name, values.size(), stage.time.size()));
  }
  stage.values[k] = std::move(values);
}

}  // namespace gudgeon
