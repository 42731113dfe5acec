// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Slider motion with its error against the ideal mechanism, driver efforts, contact forces: signals over time.
#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/display_unit.h"

namespace gudgeon {

namespace {

/// Cycles that a signal over time shows at first.
constexpr double kCyclesShown = 2.0;

enum class SignalForm { value, error };

void show_last_cycles(Figure& figure, const RunRecord& run) {
  for (const StageRecord& stage : run.stages) {
    const bool is_drawn = std::ranges::find(figure.curves, stage.name, &FigureCurve::group) != figure.curves.end();
    if (!is_drawn || stage.time.empty() || !(stage.cycle_time > 0.0)) continue;
    figure.x_end = stage.time.back();
    figure.x_begin = std::max(stage.time.front(), figure.x_end - kCyclesShown * stage.cycle_time);
  }
}

std::string find_unit(const RunRecord& run, const std::string& channel) {
  for (const StageRecord& stage : run.stages) {
    const auto found = std::ranges::find(stage.channels, channel, &Channel::name);
    if (found != stage.channels.end()) return found->unit;
  }
  return {};
}

/// The channel in every stage that has it; no curves when none has.
Figure make_signal_figure(Signals& signals, const std::string& channel, SignalForm form, std::string y_label) {
  Figure figure;
  figure.kind = FigureKind::time;
  for (const StageRecord& stage : signals.run().stages) {
    if (form == SignalForm::error && stage.name == kIdealStageName) continue;
    const Numbers values =
        form == SignalForm::error ? signals.find_error_of(stage, channel) : signals.find_values_of(stage, channel);
    if (!values) continue;
    FigureCurve curve = make_stage_curve(signals.run(), stage, signals.find_time(stage), values);
    curve.cycle_samples = find_cycle_samples(stage);
    figure.curves.push_back(std::move(curve));
  }
  figure.x = {"Time", "s", "s", 1.0};
  figure.y = make_y_axis(std::move(y_label), find_unit(signals.run(), channel), figure.curves);
  show_last_cycles(figure, signals.run());
  return figure;
}

/// "slider_9.x_velocity": owner "slider_9", quantity "velocity", place " in x".
struct MotionChannel {
  std::string owner;
  std::string quantity;
  std::string place;
};

MotionChannel split_motion_channel(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  const std::string part = channel.substr(dot + 1);
  const std::size_t line = part.find('_');
  if (part == "angle") return {channel.substr(0, dot), "angle", ""};
  if (part == "angle_rate") return {channel.substr(0, dot), "angular velocity", ""};
  if (part == "angle_acceleration") return {channel.substr(0, dot), "angular acceleration", ""};
  const std::string quantity = line == std::string::npos ? "displacement" : part.substr(line + 1);
  return {channel.substr(0, dot), quantity, " in " + part.substr(0, line)};
}

}  // namespace

std::vector<Figure> make_motion_figures(Signals& signals) {
  std::vector<Figure> figures;
  for (const std::string& channel : find_motion_channels(signals.run())) {
    const auto [owner, quantity, place] = split_motion_channel(channel);
    const std::string label = capitalize(quantity) + place;
    Figure motion = make_signal_figure(signals, channel, SignalForm::value, label);
    motion.id = channel;
    motion.title = fmt::format("{} of {}{}", capitalize(quantity), owner, place);
    Figure error = make_signal_figure(signals, channel, SignalForm::error, fmt::format("Error of {}", quantity));
    error.id = channel + ".error";
    error.title = fmt::format("Error of the {} of {}{}", quantity, owner, place);
    error.caption = "Value less that of the ideal mechanism at the same time.";
    for (Figure* figure : {&motion, &error}) {
      figure->topic = "motion";
      if (!figure->curves.empty()) figures.push_back(std::move(*figure));
    }
  }
  return figures;
}

std::vector<Figure> make_drive_figures(Signals& signals) {
  std::vector<Figure> figures;
  for (const Channel& channel : find_effort_channels(signals.run())) {
    const bool turns = channel.unit == "N m";
    const std::string owner = channel.name.substr(0, channel.name.rfind('.'));
    Figure figure = make_signal_figure(signals, channel.name, SignalForm::value, turns ? "Torque" : "Force");
    figure.id = channel.name;
    figure.topic = "drive";
    figure.title = fmt::format("{} of driver {}", turns ? "Torque" : "Force", owner);
    if (!figure.curves.empty()) figures.push_back(std::move(figure));
  }
  return figures;
}

std::vector<Figure> make_contact_figures(Signals& signals) {
  std::vector<Figure> figures;
  for (const std::string& joint : find_clearance_joints(signals.run())) {
    const std::string channel = joint + ".normal_force";
    Figure figure = make_signal_figure(signals, channel, SignalForm::value, "Normal force");
    figure.id = channel;
    figure.topic = "contact";
    figure.title = fmt::format("Contact force in {}", joint);
    figure.caption = "Zero in free flight. Peaks between two recorded samples are in the table of peaks.";
    if (!figure.curves.empty()) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace gudgeon
