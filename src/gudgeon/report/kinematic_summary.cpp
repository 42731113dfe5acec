// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One table a question.
#include "gudgeon/report/kinematic_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "gudgeon/report/number_format.h"
#include "gudgeon/report/table.h"

namespace gudgeon {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Angles in degrees, everything else with a fitting prefix.
std::string format_value(double value, std::string_view unit) {
  if (unit != "rad") return format_engineering(value, unit);
  const double degrees = value / kDegree;
  return fmt::format("{:.3f}°", std::abs(degrees) < 5e-4 ? 0.0 : degrees);  // no minus before zero
}

std::string format_time(const KinematicRecord& record, DriverTime at) {
  if (record.driver.empty()) return fmt::format("{:.6g} s", at.time);
  return format_value(at.driver_value, record.driver_unit);
}

std::string format_sample_time(const KinematicRecord& record, double time) {
  const std::vector<double>* driver = find_values(record.motion, record.driver + ".value");
  const auto found = std::ranges::find(record.motion.time, time);
  if (driver == nullptr || found == record.motion.time.end()) return fmt::format("{:.6g} s", time);
  return format_time(record, {time, (*driver)[static_cast<std::size_t>(found - record.motion.time.begin())]});
}

/// A row a channel whose name ends so: least and greatest value and where they occur.
std::string render_ranges(const KinematicRecord& record, std::string_view title,
                          std::initializer_list<std::string_view> endings, bool color) {
  Table table({{"channel"},
               {"least", Alignment::right},
               {"at", Alignment::right},
               {"greatest", Alignment::right},
               {"at", Alignment::right},
               {"range", Alignment::right}});
  for (const Channel& channel : record.motion.channels) {
    const auto ends = [&](std::string_view ending) { return channel.name.ends_with(ending); };
    const ChannelStatistics* one = find_statistics(record.motion, channel.name);
    if (one == nullptr || !std::ranges::any_of(endings, ends)) continue;
    table.add_row({channel.name, format_value(one->minimum, channel.unit),
                   format_sample_time(record, one->minimum_time), format_value(one->maximum, channel.unit),
                   format_sample_time(record, one->maximum_time),
                   format_value(one->maximum - one->minimum, channel.unit)});
  }
  return table.empty() ? "" : render_title(title, color) + table.render(color);
}

/// What drives and what holds: extremes, where they occur, and the root of the mean square over time.
std::string render_efforts(const KinematicRecord& record, bool color) {
  Table table({{"channel"},
               {"least", Alignment::right},
               {"at", Alignment::right},
               {"greatest", Alignment::right},
               {"at", Alignment::right},
               {"rms", Alignment::right}});
  for (const std::string_view ending : {".effort", ".force", ".moment"}) {
    for (const Channel& channel : record.motion.channels) {
      const ChannelStatistics* one = find_statistics(record.motion, channel.name);
      if (one == nullptr || !channel.name.ends_with(ending)) continue;
      table.add_row({channel.name, format_value(one->minimum, channel.unit),
                     format_sample_time(record, one->minimum_time), format_value(one->maximum, channel.unit),
                     format_sample_time(record, one->maximum_time), format_value(one->rms, channel.unit)});
    }
  }
  return table.empty() ? "" : render_title("Driver efforts, joint forces and moments", color) + table.render(color);
}

std::string render_transmissions(const KinematicRecord& record, bool color) {
  Table table({{"loop closed at"},
               {"angle"},
               {"least", Alignment::right},
               {"at", Alignment::right},
               {"greatest", Alignment::right},
               {"at", Alignment::right}});
  constexpr double kConstant = 1e-9;  // [rad] the place of an extreme this flat means nothing
  for (const TransmissionRange& range : record.transmissions) {
    const bool is_constant = range.greatest - range.least < kConstant;
    const auto place = [&](DriverTime at) { return is_constant ? "throughout" : format_time(record, at); };
    table.add_row({range.joint, range.is_pressure_angle ? "pressure" : "transmission", format_value(range.least, "rad"),
                   place(range.least_at), format_value(range.greatest, "rad"), place(range.greatest_at)});
  }
  if (table.empty()) return {};
  return render_title("Transmission angles", color) + table.render(color) +
         "  transmission: between the two links that close a loop, best at 90°; pressure: between link and guide, best "
         "at 0°\n";
}

std::string render_dead_centres(const KinematicRecord& record, bool color) {
  Table table({{"dead centre of"},
               {"limit"},
               {"position", Alignment::right},
               {"at", Alignment::right},
               {"time", Alignment::right}});
  for (const DeadCentre& centre : record.dead_centres) {
    table.add_row({centre.of, centre.is_greatest ? "greatest" : "least", format_value(centre.value, centre.unit),
                   format_time(record, centre.at), fmt::format("{:.9g} s", centre.at.time)});
  }
  return table.empty() ? "" : render_title("Dead centres", color) + table.render(color);
}

}  // namespace

std::string render_kinematics(const KinematicRecord& record, bool color) {
  const StageRecord& motion = record.motion;
  std::string text = fmt::format("{} samples up to t = {:.6g} s, one cycle takes {:.6g} s", motion.time.size(),
                                 motion.end_time, motion.cycle_time);
  if (!record.driver.empty()) text += fmt::format("; \"at\" is the value of driver '{}'", record.driver);
  text += "\n";
  if (!motion.time.empty()) {
    text += render_ranges(record, "Angles and strokes", {".angle", ".displacement"}, color);
    text += render_ranges(record, "Rates and accelerations",
                          {".angle_rate", ".angle_acceleration", ".speed", ".acceleration"}, color);
    text += render_efforts(record, color);
    text += render_transmissions(record, color);
    text += render_dead_centres(record, color);
  }
  for (const BranchChange& change : record.branch_changes) {
    text += fmt::format("\n  branch changes at joint '{}' from {} to {}: t = {:.9g} s, driver at {}\n", change.joint,
                        change.to_left ? "right" : "left", change.to_left ? "left" : "right", change.at.time,
                        format_time(record, change.at));
  }
  return text;
}

}  // namespace gudgeon
