// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of stages, peaks and energy.
#include "gudgeon/report/stage_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/analysis/slider_coordinates.h"
#include "gudgeon/analysis/surface_limits.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/table.h"

namespace gudgeon {

namespace {

/// A table with a text column and a right-aligned one a stage.
Table make_stage_columns(const RunRecord& run, std::string first) {
  std::vector<TableColumn> columns{{std::move(first), Alignment::left}};
  for (const StageRecord& stage : run.stages) columns.push_back({stage.name, Alignment::right});
  return Table(std::move(columns));
}

/// The statistics of a stage by the names of their channels.
std::unordered_map<std::string_view, const ChannelStatistics*> index_statistics(const StageRecord& stage) {
  std::unordered_map<std::string_view, const ChannelStatistics*> index;
  for (const ChannelStatistics& statistics : stage.statistics) index.emplace(statistics.channel, &statistics);
  return index;
}

/// Channels whose peaks a reader asks for first, in the order recorded, each once over all stages.
std::vector<Channel> find_peak_channels(const RunRecord& run) {
  std::vector<Channel> peaks;
  std::unordered_set<std::string_view> known;
  for (const StageRecord& stage : run.stages) {
    const auto statistics = index_statistics(stage);
    std::unordered_set<std::string> accelerations;
    for (const std::string& coordinate : find_slider_coordinates(stage)) {
      accelerations.insert(coordinate + "_acceleration");
    }
    for (const Channel& channel : stage.channels) {
      const std::string& name = channel.name;
      const bool wanted = name.ends_with(".normal_force") || name.ends_with(".effort") || accelerations.contains(name);
      if (wanted && statistics.contains(name) && known.insert(name).second) peaks.push_back(channel);
    }
  }
  return peaks;
}

}  // namespace

const char* name_status(StageStatus status) {
  switch (status) {
    case StageStatus::finished:
      return "finished";
    case StageStatus::stopped:
      return "stopped";
    case StageStatus::failed:
      return "failed";
  }
  return "";
}

std::string render_stages(const RunRecord& run, bool color) {
  if (run.stages.empty()) return render_title("No stage was run", color);
  Table table({{"stage"},
               {"status"},
               {"cycles", Alignment::right},
               {"reached", Alignment::right},
               {"wall time", Alignment::right},
               {"evaluations", Alignment::right},
               {"steps", Alignment::right},
               {"rejected", Alignment::right},
               {"onsets", Alignment::right}});
  std::string messages;
  for (const StageRecord& stage : run.stages) {
    const SolverStatistics& solver = stage.solver;
    table.add_row({stage.name, name_status(stage.status), fmt::format("{}", stage.cycles),
                   format_engineering(stage.end_time, "s"), format_engineering(solver.wall_time, "s"),
                   format_count(solver.evaluations), format_count(solver.accepted_steps),
                   format_count(solver.rejected_steps), format_count(solver.onsets)});
    for (const std::string& message : {stage.message, explain_imbalance(stage)}) {
      if (!message.empty()) messages += fmt::format("  {}: {}\n", stage.name, message);
    }
  }
  return render_title("Stages", color) + table.render(color) + messages;
}

std::string render_limits_exceeded(const RunRecord& run, bool color) {
  std::string lines;
  for (const LimitExceeded& exceeded : find_limits_exceeded(run)) lines += fmt::format("  {}\n", describe(exceeded));
  return lines.empty() ? "" : render_title("Remarks", color) + lines;
}

std::string render_peaks(const RunRecord& run, bool color) {
  Table table = make_stage_columns(run, "channel");
  std::vector<std::unordered_map<std::string_view, const ChannelStatistics*>> of_stages;
  for (const StageRecord& stage : run.stages) of_stages.push_back(index_statistics(stage));
  for (const Channel& channel : find_peak_channels(run)) {
    std::vector<std::string> row{channel.name};
    for (const auto& statistics : of_stages) {
      const auto found = statistics.find(channel.name);
      row.push_back(found == statistics.end() ? kNoNumber : format_engineering(found->second->peak(), channel.unit));
    }
    table.add_row(std::move(row));
  }
  if (table.empty()) return "";
  return render_title("Peaks (signed value of largest magnitude, over the counted cycles)", color) +
         table.render(color);
}

std::string render_energy(const RunRecord& run, bool color) {
  if (run.stages.empty()) return "";
  std::vector<EnergyAudit> audits;
  for (const StageRecord& stage : run.stages) audits.push_back(check_energy(stage.energy));
  Table table = make_stage_columns(run, "energy");
  const auto add_row = [&](const char* meaning, auto render_cell) {
    std::vector<std::string> row{meaning};
    for (const EnergyAudit& audit : audits) row.push_back(render_cell(audit));
    table.add_row(std::move(row));
  };
  for (std::size_t k = 0; k < audits.front().lines.size(); ++k) {
    // What no stage has any of is left out.
    if (std::ranges::all_of(audits, [k](const EnergyAudit& audit) { return audit.lines[k].value == 0.0; })) continue;
    add_row(audits.front().lines[k].meaning,
            [k](const EnergyAudit& audit) { return format_engineering(audit.lines[k].value, "J"); });
  }
  add_row("sum (residual)", [](const EnergyAudit& audit) { return format_engineering(audit.residual, "J"); });
  add_row("energy exchanged", [](const EnergyAudit& audit) { return format_engineering(audit.exchanged, "J"); });
  add_row("scale: exchanged and held", [](const EnergyAudit& audit) { return format_engineering(audit.scale, "J"); });
  add_row("residual / scale", [](const EnergyAudit& audit) { return fmt::format("{:.1e}", audit.relative); });
  add_row("balanced", [](const EnergyAudit& audit) { return std::string(audit.balanced ? "yes" : "NO"); });
  return render_title(fmt::format("Energy balance (end − start − supplied + dissipated; balanced within {:.0e})",
                                  kEnergyTolerance),
                      color) +
         table.render(color);
}

}  // namespace gudgeon
