// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Channels, statistics, events, wear, energy and solver work of a stage.
#include "gudgeon/io/stage_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/run_tables.h"
#include "gudgeon/io/stage_channels.h"
#include "gudgeon/results/energy_balance.h"

namespace gudgeon {

namespace {

template <class Record, class Fields>
void write_reals(const Hdf5Handle& node, const Record& record, const Fields& fields) {
  for (const auto& field : fields) write_real(node, field.name, record.*field.member, field.unit);
}

const char* find_status_name(StageStatus status) {
  return std::ranges::find(kStatusNames, status, &StatusName::status)->name;
}

SampleBlock find_samples(const StageRecord& stage) { return {stage.name, stage.channels, stage.time, stage.values}; }

Hdf5Handle make_stage_group(const Hdf5Handle& stages, const std::string& name) {
  if (has_link(stages, name)) throw FileError("a stage of that name already exists");
  return make_group(stages, name, 12, 12);
}

void write_statistics(const Hdf5Handle& node, const StageRecord& stage) {
  std::unordered_map<std::string_view, const char*> units;
  for (const Channel& channel : stage.channels) units.emplace(channel.name, channel.unit.c_str());
  std::vector<StatisticsRow> rows;
  for (const ChannelStatistics& s : stage.statistics) {
    const auto channel = units.find(s.channel);
    const char* unit = channel == units.end() ? "" : channel->second;
    rows.push_back({s.channel.c_str(), unit, s.minimum, s.minimum_time, s.maximum, s.maximum_time, s.mean, s.rms});
  }
  write_table(node, "statistics", kStatisticsShape, rows.data(), rows.size());
}

void write_wear(const Hdf5Handle& node, const StageRecord& stage) {
  const Hdf5Handle group = make_group(node, "wear");
  for (const JointWear& wear : stage.wear) {
    const Hdf5Handle joint = make_group(group, wear.joint);
    write_reals(joint, wear, kWearReals);
    for (const auto& field : kWearSeries) {
      write_unit(write_series(joint, field.name, wear.*field.member), field.unit);
    }
  }
}

void write_energy(const Hdf5Handle& node, const EnergyBalance& balance) {
  const Hdf5Handle group = make_group(node, "energy");
  write_reals(group, balance, kEnergyReals);
  // They follow from the others, for other programs.
  write_real(group, "residual", balance.residual(), "J");
  write_real(group, "allowed_residual", find_allowed_residual(balance), "J");
}

void write_solver(const Hdf5Handle& node, const SolverStatistics& solver) {
  const Hdf5Handle group = make_group(node, "solver");
  for (const auto& field : kSolverCounts) write_count(group, field.name, solver.*field.member);
  write_reals(group, solver, kSolverReals);
}

/// Everything but the samples.
void write_findings(const Hdf5Handle& node, const StageRecord& stage) {
  write_text(node, "status", find_status_name(stage.status));
  write_text(node, "message", stage.message);
  write_count(node, "cycles", stage.cycles);
  write_reals(node, stage, kStageReals);
  write_statistics(node, stage);
  write_table(node, "events", kEventShape, stage.events.data(), stage.events.size());
  write_wear(node, stage);
  write_energy(node, stage.energy);
  write_solver(node, stage.solver);
}

}  // namespace

void write_stage(const Hdf5Handle& stages, const StageRecord& stage) {
  const Hdf5Handle node = make_stage_group(stages, stage.name);
  write_channels(node, find_samples(stage));
  write_findings(node, stage);
}

void begin_stage(const Hdf5Handle& stages, const SampleBlock& block) {
  begin_channels(make_stage_group(stages, std::string(block.stage)), block);
}

void extend_stage(const Hdf5Handle& stages, const SampleBlock& block) {
  extend_channels(open_group(stages, std::string(block.stage)), block);
}

void reopen_stage(const Hdf5Handle& stages, const std::string& name, std::size_t n_samples) {
  const Hdf5Handle stage = open_group(stages, name);
  for (const std::string& member : find_members(stage)) {
    if (member != "channels") remove_link(stage, member);
  }
  cut_channels(stage, n_samples);
}

void end_stage(const Hdf5Handle& stages, const StageRecord& stage) {
  extend_stage(stages, find_samples(stage));
  write_findings(open_group(stages, stage.name), stage);
}

}  // namespace gudgeon
