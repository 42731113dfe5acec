// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The last stage of each case in three numbers.
#include "gudgeon/report/html/case_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/analysis/wear_summary.h"
#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/stage_section.h"

namespace gudgeon {

namespace {

/// A description of this many bytes says what it must; longer ones are cut where a word ends.
constexpr std::size_t kLongestDescription = 120;

std::string shorten(const std::string& text) {
  if (text.size() <= kLongestDescription) return text;
  const std::size_t space = text.rfind(' ', kLongestDescription);
  return text.substr(0, space == std::string::npos ? 0 : space) + " …";
}

/// Largest magnitude of the stage's statistics whose channel ends so; NaN without any.
double find_largest_peak(const StageRecord& stage, std::string_view ending) {
  double largest = std::nan("");
  for (const ChannelStatistics& one : stage.statistics) {
    if (one.channel.ends_with(ending)) largest = std::fmax(largest, std::abs(one.peak()));
  }
  return largest;
}

double find_deepest_wear(const RunRecord& run) {
  double deepest = std::nan("");
  for (const JointWearSummary& joint : summarize_wear(run, run.stages.size() - 1)) {
    deepest = std::fmax(deepest, joint.accumulated.depth);
  }
  return deepest;
}

}  // namespace

HtmlTable CaseList::make_table() {
  return {"All cases, after their last stage",
          {"case", "what it is", "ended", "on this page", "largest contact force", "deepest wear"},
          4};
}

void CaseList::add(const ReportCase& one, const std::string& extent) {
  if (++n_cases_ > kMostListed) return;
  const RunRecord& run = one.run;
  if (run.stages.empty()) {
    table_.add_row({run.case_name, shorten(one.case_description), "no stage", extent, kNoNumber, kNoNumber});
    return;
  }
  const StageRecord& last = run.stages.back();
  const bool is_balanced = std::ranges::none_of(run.stages, is_unbalanced);
  table_.add_row({run.case_name, shorten(one.case_description),
                  fmt::format("{}{}", name_status(last.status), is_balanced ? "" : ", energy balance does not close"),
                  extent, format_engineering(find_largest_peak(last, ".normal_force"), "N"),
                  format_engineering(find_deepest_wear(run), "m")});
}

std::string CaseList::render() const {
  if (n_cases_ < 2) return {};
  std::string html = table_.render();
  if (n_cases_ > kMostListed) html += make_paragraph(fmt::format("… and {} more.", n_cases_ - kMostListed), "warning");
  return html;
}

}  // namespace gudgeon
