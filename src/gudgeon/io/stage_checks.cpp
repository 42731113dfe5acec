// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stage by part.
#include "gudgeon/io/stage_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/shown_text.h"
#include "gudgeon/io/record_fields.h"

namespace gudgeon {

namespace {

[[noreturn]] void refuse(std::string_view what, double value) {
  throw FileError(fmt::format("'{}' is {}, which no run has", what, value));
}

/// Texts of one line each.
void check_line(std::string_view what, std::string_view text) {
  if (show_line(text) == text) return;
  throw FileError(fmt::format("{} '{}' holds control characters, which no run has", what, show_line(text)));
}

void check_texts(const StageRecord& stage) {
  for (const Channel& channel : stage.channels) {
    check_line("the channel", channel.name);
    check_line("the symbol", channel.symbol);
    check_line("the unit", channel.unit);
    check_line("the description", channel.description);
  }
  for (const JointWear& wear : stage.wear) check_line("the joint", wear.joint);
  for (const ChannelStatistics& s : stage.statistics) check_line("the channel", s.channel);
}

template <class Record, class Fields>
void require_finite(const Record& record, const Fields& fields) {
  for (const auto& field : fields) {
    if (!std::isfinite(record.*field.member)) refuse(field.name, record.*field.member);
  }
}

void check_solver(const SolverStatistics& solver) {
  for (const auto& field : kSolverCounts) {
    if (solver.*field.member < 0) refuse(field.name, static_cast<double>(solver.*field.member));
  }
  for (const auto& field : kSolverReals) {
    if (!(solver.*field.member >= 0.0)) refuse(field.name, solver.*field.member);
  }
}

/// Radii may be infinite: the sides of a slot are plane.
void check_sizes(const JointWear& wear) {
  for (const auto& [name, value] : {std::pair<std::string_view, double>{"bearing_radius", wear.bearing_radius},
                                    {"journal_radius", wear.journal_radius}}) {
    if (!(value > 0.0)) refuse(name, value);
  }
  for (const auto& [name, value] : {std::pair<std::string_view, double>{"width", wear.width},
                                    {"slot_length", wear.slot_length},
                                    {"sliding_distance", wear.sliding_distance},
                                    {"contact_time", wear.contact_time}}) {
    if (!(value >= 0.0 && std::isfinite(value))) refuse(name, value);
  }
  for (const auto& [name, value] : {std::pair<std::string_view, double>{"clearance", wear.clearance},
                                    {"archard_volume", wear.archard_volume},
                                    {"removed_volume", wear.removed_volume},
                                    {"impulse", wear.impulse}}) {
    if (!std::isfinite(value)) refuse(name, value);
  }
}

/// Depths of one kind are as many as those of its surface, or none.
void check_depths(const JointWear& wear) {
  for (const auto& field : kWearSeries) {
    const std::vector<double>& depths = wear.*field.member;
    const auto odd = std::ranges::find_if_not(depths, [](double d) { return std::isfinite(d); });
    if (odd != depths.end()) refuse(field.name, *odd);
  }
  const auto fits = [](const std::vector<double>& added, const std::vector<double>& depths) {
    return added.empty() || added.size() == depths.size();
  };
  const bool is_whole =
      fits(wear.bearing_depth_added, wear.bearing_depth) && fits(wear.journal_depth_added, wear.journal_depth) &&
      fits(wear.total_depth_added, wear.bearing_depth) && wear.bearing_depth.size() % wear.n_bearing_surfaces() == 0;
  if (!is_whole) throw FileError(fmt::format("the depths of joint '{}' are not as many as its cells", wear.joint));
}

void check_event(const ContactEvent& event, const StageRecord& stage) {
  const bool known = event.joint >= 0 && static_cast<std::size_t>(event.joint) < stage.wear.size();
  if (!known) throw FileError(fmt::format("an event names joint {} of {}", event.joint, stage.wear.size()));
  if (event.contact < 0) refuse("contact", event.contact);
  if (!std::isfinite(event.onset_time)) refuse("onset_time", event.onset_time);
  if (!(event.duration >= 0.0 && std::isfinite(event.duration))) refuse("duration", event.duration);
  if (!std::isfinite(event.peak_force)) refuse("peak_force", event.peak_force);
}

}  // namespace

void check_stage_name(std::string_view name) {
  constexpr std::size_t kLongest = 100;  // [bytes] files are named after it, with endings
  const bool is_plain = std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (is_plain && !name.empty() && name.size() <= kLongest) return;
  throw FileError(fmt::format("no run has a stage of the name '{}': names are of letters, digits and '_', at most {}",
                              shorten(show_line(name), kLongest), kLongest));
}

void check_stage(const StageRecord& stage) {
  check_texts(stage);
  require_finite(stage, kStageReals);
  if (stage.cycle_time < 0.0) refuse("cycle_time", stage.cycle_time);
  if (stage.status == StageStatus::finished) require_finite(stage.energy, kEnergyReals);
  check_solver(stage.solver);
  for (const JointWear& wear : stage.wear) {
    check_sizes(wear);
    check_depths(wear);
  }
  for (const ContactEvent& event : stage.events) check_event(event, stage);
  for (const ChannelStatistics& s : stage.statistics) {
    if (s.minimum > s.maximum) {
      throw FileError(
          fmt::format("the minimum of channel '{}', {}, is above its maximum, {}", s.channel, s.minimum, s.maximum));
    }
  }
}

void check_times(std::span<const double> times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] < times[i - 1])) {
      throw FileError(
          fmt::format("'time' of sample {} is {}, which cannot follow {}", i, times[i], i == 0 ? 0.0 : times[i - 1]));
    }
  }
}

}  // namespace gudgeon
