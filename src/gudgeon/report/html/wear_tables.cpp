// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear, energy and solver work in tables.
#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/analysis/surface_limits.h"
#include "gudgeon/analysis/wear_summary.h"
#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/html/case_sections.h"
#include "gudgeon/report/html/html_text.h"
#include "gudgeon/report/joint_section.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/stage_section.h"

namespace gudgeon {

namespace {

/// A table with one column of words and one a stage.
HtmlTable make_stage_table(const RunRecord& run, std::string caption, std::string first) {
  std::vector<std::string> columns{std::move(first)};
  for (const StageRecord& stage : run.stages) columns.push_back(label_stage(stage.name));
  return {std::move(caption), std::move(columns)};
}

/// Cubic millimetres: worn volumes of machine parts are read in them.
std::string print_volume(double volume) { return format_number(1e9 * volume) + " mm³"; }

template <class Print>
void add_stage_row(HtmlTable& table, const RunRecord& run, std::string name, Print print) {
  std::vector<std::string> row{std::move(name)};
  for (const StageRecord& stage : run.stages) row.push_back(print(stage));
  table.add_row(std::move(row));
}

}  // namespace

std::string render_wear_table(const RunRecord& run) {
  HtmlTable table(
      "What each stage wears away, times the wear acceleration",
      {"joint", "stage", "deepest so far", "at", "bearing", "journal", "deepest added", "removed", "k F s", "worn at"},
      2);
  std::string notes;
  for (const std::string& joint : find_clearance_joints(run)) {
    for (std::size_t k = 0; k < run.stages.size(); ++k) {
      const std::vector<JointWearSummary> summaries = summarize_wear(run, k);
      const auto found = std::ranges::find(summaries, joint, &JointWearSummary::joint);
      if (found == summaries.end() || !(found->accumulated.depth > 0.0)) continue;
      const JointWearSummary& wear = *found;
      const std::string stage = label_stage(run.stages[k].name);
      table.add_row({wear.joint, stage, format_engineering(wear.accumulated.depth, "m"),
                     render_place(wear.accumulated, wear.is_slot), format_engineering(wear.bearing.depth, "m"),
                     format_engineering(wear.journal.depth, "m"), format_engineering(wear.added.depth, "m"),
                     print_volume(wear.removed_volume), print_volume(wear.archard_volume), render_worn(wear)});
      if (wear.clearance_share <= kFarthestExtrapolation) continue;
      notes +=
          make_paragraph(fmt::format("Stage “{}” deepens joint {} by {:.0f} % of its clearance at once; its motion "
                                     "would have changed on the way.",
                                     stage, wear.joint, 100.0 * wear.clearance_share),
                         "warning");
    }
  }
  if (table.empty()) return {};
  return table.render() +
         make_paragraph(
             fmt::format("Depths of bearing and journal together unless said, in the bearing's body, after the "
                         "stage. The next stage runs on these surfaces and gives them its name in figures: what “no "
                         "wear” wears away is the wear depth of “first wear”. What the last stage wears away is in "
                         "this table only. Worn: deeper than {:.0f} % of the deepest. Removed and k F s (Archard): of "
                         "the stage alone.",
                         100.0 * kWornFraction),
             "note") +
         notes;
}

std::string render_energy_table(const RunRecord& run) {
  if (run.stages.empty()) return {};
  HtmlTable table = make_stage_table(run, "Energy balance: end − start − supplied + dissipated", "energy");
  const std::size_t n_lines = check_energy(run.stages.front().energy).lines.size();
  for (std::size_t k = 0; k < n_lines; ++k) {
    const auto find_line = [k](const StageRecord& stage) { return check_energy(stage.energy).lines[k]; };
    if (std::ranges::all_of(run.stages, [&](const StageRecord& s) { return find_line(s).value == 0.0; })) continue;
    add_stage_row(table, run, find_line(run.stages.front()).meaning,
                  [&](const StageRecord& s) { return format_engineering(find_line(s).value, "J"); });
  }
  add_stage_row(table, run, "sum (residual)",
                [](const StageRecord& s) { return format_engineering(check_energy(s.energy).residual, "J"); });
  add_stage_row(table, run, "energy exchanged",
                [](const StageRecord& s) { return format_engineering(s.energy.exchanged, "J"); });
  add_stage_row(table, run, "scale: exchanged and held",
                [](const StageRecord& s) { return format_engineering(find_energy_scale(s.energy), "J"); });
  add_stage_row(table, run, "residual / scale",
                [](const StageRecord& s) { return fmt::format("{:.1e}", check_energy(s.energy).relative); });
  add_stage_row(table, run, fmt::format("balanced within {:.0e}", kEnergyTolerance),
                [](const StageRecord& s) { return std::string(is_balanced(s.energy) ? "yes" : "NO"); });
  return table.render();
}

std::string render_solver_table(const RunRecord& run) {
  if (run.stages.empty()) return make_paragraph("No stage was run.", "warning");
  HtmlTable table = make_stage_table(run, "How each stage was computed", "solver");
  const auto add_count = [&](const char* name, std::int64_t SolverStatistics::*member) {
    add_stage_row(table, run, name, [&](const StageRecord& s) { return format_count(s.solver.*member); });
  };
  const auto add_real = [&](const char* name, const char* unit, double SolverStatistics::*member) {
    add_stage_row(table, run, name, [&](const StageRecord& s) { return format_engineering(s.solver.*member, unit); });
  };
  add_stage_row(table, run, "status", [](const StageRecord& s) { return std::string(name_status(s.status)); });
  add_stage_row(table, run, "counted cycles", [](const StageRecord& s) { return format_count(s.cycles); });
  add_stage_row(table, run, "time reached", [](const StageRecord& s) { return format_engineering(s.end_time, "s"); });
  add_count("evaluations", &SolverStatistics::evaluations);
  add_count("accepted steps", &SolverStatistics::accepted_steps);
  add_count("rejected steps", &SolverStatistics::rejected_steps);
  add_count("contact onsets", &SolverStatistics::onsets);
  add_count("separations", &SolverStatistics::separations);
  add_real("smallest step", "s", &SolverStatistics::smallest_step);
  add_real("largest step", "s", &SolverStatistics::largest_step);
  add_real("closure residual", "m", &SolverStatistics::closure_residual);
  add_real("wall time", "s", &SolverStatistics::wall_time);
  std::string html = table.render();
  for (const StageRecord& stage : run.stages) {
    if (stage.message.empty()) continue;
    html += make_paragraph(
        fmt::format("Stage “{}” {}: {}", label_stage(stage.name), name_status(stage.status), stage.message), "warning");
  }
  for (const LimitExceeded& exceeded : find_limits_exceeded(run)) {
    html += make_paragraph(fmt::format("Remark, {}", describe(exceeded)), "warning");
  }
  return html;
}

}  // namespace gudgeon
