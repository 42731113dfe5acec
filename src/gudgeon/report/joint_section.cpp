// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of wear and contact.
#include "gudgeon/report/joint_section.h"

#include <fmt/format.h>

#include <cmath>

#include "gudgeon/analysis/contact_summary.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/table.h"

namespace gudgeon {

namespace {

constexpr std::size_t kRangesShown = 4;  // what fits a line; more are scattered single cells

std::string format_percent(double part) { return fmt::format("{:.1f} %", 100.0 * part); }

/// A last cell that ends at 360 stays 360, one that passes it starts again from 0.
std::string render_range(const AngleRange& range) {
  const double end = range.end > 360.0 ? range.end - 360.0 : range.end;
  return fmt::format("{:.0f}–{:.0f}°", range.begin, end);
}

const char* name_side(std::size_t side) { return side == 0 ? "left" : "right"; }

std::string render_extrapolation(const std::string& stage, const JointWearSummary& wear) {
  return fmt::format(
      "  note: stage {} deepens joint {} by {:.0f} % of its clearance at once; its motion would have changed on the "
      "way.\n"
      "        Lower study.wear_acceleration and take more study.wear_stages.\n",
      stage, wear.joint, 100.0 * wear.clearance_share);
}

}  // namespace

std::string render_place(const DeepestPoint& point, bool is_slot) {
  if (!is_slot) return format_degrees(point.angle);
  return fmt::format("{} {:.1f} mm", name_side(point.surface), 1e3 * point.position);
}

std::string render_worn(const JointWearSummary& wear) {
  return wear.is_slot ? render_side_ranges(wear.worn_sides) : render_ranges(wear.worn);
}

std::string render_ranges(std::span<const AngleRange> ranges) {
  if (ranges.empty()) return "none";
  std::string text;
  for (const AngleRange& range : ranges.first(std::min(ranges.size(), kRangesShown))) {
    text += (text.empty() ? "" : ", ") + render_range(range);
  }
  if (ranges.size() > kRangesShown) text += fmt::format(" and {} more", ranges.size() - kRangesShown);
  return text;
}

std::string render_side_ranges(std::span<const SideRange> ranges) {
  if (ranges.empty()) return "none";
  std::string text;
  for (const SideRange& range : ranges.first(std::min(ranges.size(), kRangesShown))) {
    text += fmt::format("{}{} {:.1f} to {:.1f} mm", text.empty() ? "" : ", ", name_side(range.side), 1e3 * range.begin,
                        1e3 * range.end);
  }
  if (ranges.size() > kRangesShown) text += fmt::format(" and {} more", ranges.size() - kRangesShown);
  return text;
}

std::string render_wear(const RunRecord& run, bool color) {
  Table table({{"stage"},
               {"joint"},
               {"deepest added", Alignment::right},
               {"at", Alignment::right},
               {"mean added", Alignment::right},
               {"deepest so far", Alignment::right},
               {"at", Alignment::right},
               {"removed", Alignment::right},
               {"k_d F s", Alignment::right},
               {"worn"}});
  std::string notes;
  for (std::size_t k = 0; k < run.stages.size(); ++k) {
    for (const JointWearSummary& wear : summarize_wear(run, k)) {
      if (wear.clearance_share > kFarthestExtrapolation) notes += render_extrapolation(run.stages[k].name, wear);
      table.add_row({run.stages[k].name, wear.joint, format_engineering(wear.added.depth, "m"),
                     render_place(wear.added, wear.is_slot), format_engineering(wear.mean_depth_added, "m"),
                     format_engineering(wear.accumulated.depth, "m"), render_place(wear.accumulated, wear.is_slot),
                     format_engineering(wear.removed_volume, "m^3"), format_engineering(wear.archard_volume, "m^3"),
                     render_worn(wear)});
    }
  }
  if (table.empty()) return "";
  return render_title("Wear (bearing and journal together, in the bearing's body, times the wear acceleration)",
                      color) +
         table.render(color) +
         fmt::format("  worn: deeper than {:.0f} % of the deepest so far; removed and k_d F s are of the stage alone\n",
                     100.0 * kWornFraction) +
         notes;
}

std::string render_contacts(const RunRecord& run, bool color) {
  Table table({{"stage"},
               {"joint"},
               {"onsets", Alignment::right},
               {"in contact", Alignment::right},
               {"in flight", Alignment::right},
               {"of contact: lasting", Alignment::right},
               {"impacts", Alignment::right},
               {"mean force", Alignment::right},
               {"largest force", Alignment::right}});
  for (const StageRecord& stage : run.stages) {
    for (const JointContactSummary& contact : summarize_contacts(stage)) {
      table.add_row({stage.name, contact.joint, format_count(contact.onsets), format_percent(contact.contact_fraction),
                     format_percent(contact.flight_fraction), format_percent(contact.lasting_fraction),
                     format_percent(contact.impact_fraction), format_engineering(contact.mean_force, "N"),
                     format_engineering(contact.largest_force, "N")});
    }
  }
  if (table.empty()) return "";
  return render_title("Contacts", color) + table.render(color) +
         fmt::format("  lasting: longer than {:.0f} % of a cycle; mean force: while in contact\n",
                     100.0 * kLastingFraction);
}

}  // namespace gudgeon
