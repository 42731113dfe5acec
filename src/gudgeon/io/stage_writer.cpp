// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Channels, statistics, events, wear, energy and solver work of a stage.
#include "gudgeon/io/stage_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/run_tables.h"

namespace gudgeon {

namespace {

void write_quantity(const Hdf5Handle& node, const std::string& name, double value, const char* unit) {
  write_real_attribute(node, name, value);
  write_text_attribute(node, name + ".unit", unit);
}

template <class Record, class Fields>
void write_reals(const Hdf5Handle& node, const Record& record, const Fields& fields) {
  for (const auto& field : fields) write_quantity(node, field.name, record.*field.member, field.unit);
}

const char* find_status_name(StageStatus status) {
  return std::ranges::find(kStatusNames, status, &StatusName::status)->name;
}

void write_channels(const Hdf5Handle& node, const StageRecord& stage) {
  if (stage.values.size() != stage.channels.size()) {
    throw FileError(fmt::format("stage has {} channels but values of {}", stage.channels.size(), stage.values.size()));
  }
  write_text_attribute(write_series(node, "time", stage.time), "unit", "s");
  const Hdf5Handle group = make_group(node, "channels");
  for (std::size_t k = 0; k < stage.channels.size(); ++k) {
    const Channel& channel = stage.channels[k];
    const Hdf5Handle dataset = write_series(group, channel.name, stage.values[k]);
    write_count_attribute(dataset, "order", static_cast<std::int64_t>(k));
    write_text_attribute(dataset, "unit", channel.unit);
    write_text_attribute(dataset, "symbol", channel.symbol);
    write_text_attribute(dataset, "description", channel.description);
  }
}

void write_statistics(const Hdf5Handle& node, const StageRecord& stage) {
  std::vector<StatisticsRow> rows;
  for (const ChannelStatistics& s : stage.statistics) {
    const auto channel = std::ranges::find(stage.channels, s.channel, &Channel::name);
    const char* unit = channel == stage.channels.end() ? "" : channel->unit.c_str();
    rows.push_back({s.channel.c_str(), unit, s.minimum, s.minimum_time, s.maximum, s.maximum_time, s.mean, s.rms});
  }
  write_table(node, "statistics", kStatisticsShape, rows.data(), rows.size());
}

void write_wear(const Hdf5Handle& node, const StageRecord& stage) {
  const Hdf5Handle group = make_group(node, "wear");
  std::int64_t order = 0;
  for (const JointWear& wear : stage.wear) {
    const Hdf5Handle joint = make_group(group, wear.joint);
    write_count_attribute(joint, "order", order++);
    write_reals(joint, wear, kWearReals);
    for (const auto& field : kWearSeries) {
      write_text_attribute(write_series(joint, field.name, wear.*field.member), "unit", field.unit);
    }
  }
}

void write_energy(const Hdf5Handle& node, const EnergyLedger& ledger) {
  const Hdf5Handle group = make_group(node, "energy");
  write_reals(group, ledger, kEnergyReals);
  write_quantity(group, "residual", ledger.residual(), "J");  // follows from the others, for other programs
}

void write_solver(const Hdf5Handle& node, const SolverStatistics& solver) {
  const Hdf5Handle group = make_group(node, "solver");
  for (const auto& field : kSolverCounts) write_count_attribute(group, field.name, solver.*field.member);
  write_reals(group, solver, kSolverReals);
}

}  // namespace

void write_stage(const Hdf5Handle& stages, const StageRecord& stage, std::int64_t order) {
  const Hdf5Handle node = make_group(stages, stage.name);
  write_count_attribute(node, "order", order);
  write_text_attribute(node, "status", find_status_name(stage.status));
  write_text_attribute(node, "message", stage.message);
  write_count_attribute(node, "cycles", stage.cycles);
  write_reals(node, stage, kStageReals);
  write_channels(node, stage);
  write_statistics(node, stage);
  write_table(node, "events", kEventShape, stage.events.data(), stage.events.size());
  write_wear(node, stage);
  write_energy(node, stage.ledger);
  write_solver(node, stage.solver);
}

}  // namespace gudgeon
