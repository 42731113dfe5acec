// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables beside the ideal mechanism and beside reference values.
#include "gudgeon/report/comparison_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_set>

#include "gudgeon/analysis/ideal_comparison.h"
#include "gudgeon/analysis/slider_coordinates.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/table.h"

namespace gudgeon {

namespace {

constexpr const char* kIdealStage = "ideal";

constexpr const char* kWhatDiffers =
    "  What differs by nature: impacts between journal and bearing are chaotic, so a peak agrees in magnitude, not in\n"
    "  sign or time, and changes with any change of model, tolerance or program; values the publication does not "
    "print\n"
    "  are assumed (the model file marks them). Ratios are of magnitudes, ours over reference.\n";

/// Adds a row, or the reason why there is none.
void add_error_row(Table& table, std::string& reasons, const StageRecord& stage, const StageRecord& ideal,
                   const Channel& channel) {
  try {
    const IdealError error = find_ideal_error(stage, ideal, channel.name);
    table.add_row({stage.name, channel.name, format_engineering(error.largest, channel.unit),
                   format_engineering(error.largest_time, "s"), format_engineering(error.rms, channel.unit)});
  } catch (const NumericalError& reason) {
    reasons += fmt::format("  not compared: {}\n", reason.what());
  }
}

/// One table, three columns a stage.
std::string render_comparisons(std::span<const ReferenceComparison> comparisons, bool color) {
  std::size_t n_values = 0;
  for (const auto& c : comparisons) n_values = std::max(n_values, c.ours.size());
  std::vector<TableColumn> columns{{"quantity"}};
  for (std::size_t k = 0; k < n_values; ++k) {
    columns.push_back({name_worn_stage(k), Alignment::right});
    columns.push_back({"ours", Alignment::right});
    columns.push_back({"ratio", Alignment::right});
  }
  Table table(std::move(columns));
  for (const auto& c : comparisons) {
    std::vector<std::string> row{c.reference.quantity};
    for (std::size_t k = 0; k < c.ours.size(); ++k) {
      row.push_back(format_engineering(c.reference.values[k], c.reference.unit));
      row.push_back(format_engineering(c.ours[k], c.reference.unit));
      row.push_back(std::isnan(c.ratio[k]) ? std::string(kNoNumber) : fmt::format("{:.2f}", c.ratio[k]));
    }
    table.add_row(std::move(row));
  }
  return table.empty() ? "" : table.render(color);
}

}  // namespace

std::vector<std::string> find_ideal_channels(const RunRecord& run) {
  const StageRecord* ideal = find_stage(run, kIdealStage);
  std::vector<std::string> channels;
  if (ideal == nullptr) return channels;
  std::unordered_set<std::string_view> recorded;
  for (const Channel& channel : ideal->channels) recorded.insert(channel.name);
  for (const std::string& coordinate : find_slider_coordinates(*ideal)) {
    for (const char* ending : {"", "_velocity", "_acceleration"}) {
      if (recorded.contains(coordinate + ending)) channels.push_back(coordinate + ending);
    }
  }
  return channels;
}

std::string render_ideal_errors(const RunRecord& run, bool color) {
  const StageRecord* ideal = find_stage(run, kIdealStage);
  if (ideal == nullptr || ideal->time.empty()) return "";  // no ideal run, or only the outline was read
  Table table(
      {{"stage"}, {"channel"}, {"largest", Alignment::right}, {"at", Alignment::right}, {"rms", Alignment::right}});
  std::string reasons;
  for (const StageRecord& stage : run.stages) {
    if (&stage == ideal) continue;
    for (const std::string& name : find_ideal_channels(run)) {
      const Channel& channel = *std::ranges::find(ideal->channels, name, &Channel::name);
      add_error_row(table, reasons, stage, *ideal, channel);
    }
  }
  if (table.empty() && reasons.empty()) return "";
  return render_title("Error of the slider motion against the ideal mechanism", color) +
         (table.empty() ? "" : table.render(color)) + reasons;
}

std::string render_reference(const RunRecord& run, std::span<const ReferenceRow> reference, bool color) {
  if (reference.empty()) return "";
  std::vector<ReferenceComparison> comparisons;
  for (const ReferenceRow& row : reference) comparisons.push_back(compare_with_reference(run, row));
  return render_title("Comparison with reference values", color) + render_comparisons(comparisons, color) +
         kWhatDiffers;
}

}  // namespace gudgeon
