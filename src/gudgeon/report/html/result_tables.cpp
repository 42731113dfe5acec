// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers of the motion: peaks, errors, contacts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gudgeon/analysis/contact_summary.h"
#include "gudgeon/analysis/ideal_comparison.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/html/case_sections.h"
#include "gudgeon/report/html/html_text.h"
#include "gudgeon/report/number_format.h"

namespace gudgeon {

namespace {

/// Magnitude below which this part of the recorded samples of the counted cycles lie.
double find_percentile(const StageRecord& stage, const std::vector<double>& values, double part) {
  std::vector<double> magnitudes;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (stage.time[k] >= stage.start_time) magnitudes.push_back(std::abs(values[k]));
  }
  if (magnitudes.empty()) return std::nan("");
  const auto place = static_cast<std::ptrdiff_t>(part * static_cast<double>(magnitudes.size() - 1));
  std::ranges::nth_element(magnitudes, magnitudes.begin() + place);
  return magnitudes[static_cast<std::size_t>(place)];
}

std::vector<Channel> find_told_channels(const RunRecord& run) {
  std::vector<std::string> names;
  for (const std::string& name : find_motion_channels(run)) {
    if (name.ends_with("_acceleration")) names.push_back(name);
  }
  for (const Channel& effort : find_effort_channels(run)) names.push_back(effort.name);
  for (const std::string& joint : find_clearance_joints(run)) names.push_back(joint + ".normal_force");
  std::vector<Channel> channels;
  for (const std::string& name : names) {
    for (const StageRecord& stage : run.stages) {
      const auto found = std::ranges::find(stage.channels, name, &Channel::name);
      if (found == stage.channels.end()) continue;
      channels.push_back(*found);
      break;
    }
  }
  return channels;
}

void add_peak_row(HtmlTable& table, const StageRecord& stage, const Channel& channel) {
  const ChannelStatistics* statistics = find_statistics(stage, channel.name);
  if (statistics == nullptr) return;
  const double peak = statistics->peak();
  const double at = peak == statistics->maximum ? statistics->maximum_time : statistics->minimum_time;
  std::vector<std::string> row{channel.name,
                               label_stage(stage.name),
                               format_engineering(peak, channel.unit),
                               format_engineering(at, "s"),
                               format_engineering(statistics->rms, channel.unit),
                               format_engineering(statistics->mean, channel.unit)};
  const std::vector<double>* values = find_values(stage, channel.name);
  const bool has_values = values != nullptr && values->size() == stage.time.size();
  for (const double part : {0.5, 0.95, 0.99}) {
    row.push_back(has_values ? format_engineering(find_percentile(stage, *values, part), channel.unit)
                             : std::string(kNoNumber));
  }
  table.add_row(std::move(row));
}

std::string print_percent(double part) { return fmt::format("{:.1f} %", 100.0 * part); }

}  // namespace

std::string render_peak_table(const RunRecord& run) {
  HtmlTable table("Peaks, rms and percentiles over the counted cycles",
                  {"channel", "stage", "peak", "at", "rms", "mean", "median", "95 %", "99 %"}, 2);
  for (const Channel& channel : find_told_channels(run)) {
    for (const StageRecord& stage : run.stages) add_peak_row(table, stage, channel);
  }
  if (table.empty()) return {};
  return table.render() + make_paragraph(
                              "Peak: the signed value of largest magnitude, taken at every step. Percentiles "
                              "are of magnitudes at the recorded samples.",
                              "note");
}

std::string render_ideal_table(const RunRecord& run) {
  const StageRecord* ideal = find_stage(run, kIdealStageName);
  if (ideal == nullptr) return {};
  HtmlTable table("Error of the motion against the ideal mechanism", {"channel", "stage", "largest", "at", "rms"}, 2);
  for (const std::string& name : find_motion_channels(run)) {
    const auto channel = std::ranges::find(ideal->channels, name, &Channel::name);
    if (channel == ideal->channels.end()) continue;
    for (const StageRecord& stage : run.stages) {
      if (&stage == ideal) continue;
      try {
        const IdealError error = find_ideal_error(stage, *ideal, name);
        table.add_row({name, label_stage(stage.name), format_engineering(error.largest, channel->unit),
                       format_engineering(error.largest_time, "s"), format_engineering(error.rms, channel->unit)});
      } catch (const NumericalError&) {
        table.add_row({name, label_stage(stage.name), "not sampled at the same times", kNoNumber, kNoNumber});
      }
    }
  }
  return table.render();
}

std::string render_contact_table(const RunRecord& run) {
  HtmlTable table(
      "Where the journals spend their time",
      {"joint", "stage", "free flight", "impacts", "continuous contact", "onsets", "mean force", "largest force"}, 2);
  for (const std::string& joint : find_clearance_joints(run)) {
    for (const StageRecord& stage : run.stages) {
      for (const JointContactSummary& contact : summarize_contacts(stage)) {
        if (contact.joint != joint) continue;
        table.add_row({joint, label_stage(stage.name), print_percent(contact.flight_fraction),
                       print_percent(contact.contact_fraction * contact.impact_fraction),
                       print_percent(contact.contact_fraction * contact.lasting_fraction), format_count(contact.onsets),
                       format_engineering(contact.mean_force, "N"), format_engineering(contact.largest_force, "N")});
      }
    }
  }
  if (table.empty()) return {};
  return table.render() +
         make_paragraph(
             fmt::format("Continuous: a stay in contact longer than {:.0f} % of a cycle; an impact is shorter. "
                         "Mean force: while in contact.",
                         100.0 * kLastingFraction),
             "note");
}

}  // namespace gudgeon
