// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where journals go in their bearings: orbits, phase portraits, Poincaré maps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/display_unit.h"

namespace gudgeon {

namespace {

FigureCurve make_circle(std::string name, double radius) {
  constexpr int kSides = 180;  // 2 degrees: round on paper
  std::vector<double> x;
  std::vector<double> y;
  for (int k = 0; k <= kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    x.push_back(radius * std::cos(angle));
    y.push_back(radius * std::sin(angle));
  }
  FigureCurve curve;
  curve.name = std::move(name);
  curve.x = make_numbers(std::move(x));
  curve.y = make_numbers(std::move(y));
  curve.dashed = true;
  return curve;
}

/// The same channel pair of a joint in every stage that has clearance.
Figure make_pair_figure(Signals& signals, const std::string& x_channel, const std::string& y_channel) {
  Figure figure;
  figure.topic = "journal";
  for (const StageRecord& stage : signals.run().stages) {
    const Numbers x = signals.find_values_of(stage, x_channel);
    const Numbers y = signals.find_values_of(stage, y_channel);
    if (!x || !y) continue;
    FigureCurve curve = make_stage_curve(signals.run(), stage, x, y);
    curve.cycle_samples = find_cycle_samples(stage);
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

/// As the paper shows them: before wear and after the last stage; the others can be switched on.
void show_first_and_last(Figure& figure) {
  for (std::size_t k = 1; k + 1 < figure.curves.size(); ++k) figure.curves[k].shown = false;
}

/// One sample a cycle, at its start.
Numbers select_cycle_starts(const StageRecord& stage, const Numbers& values, std::size_t cycle_samples) {
  std::vector<double> chosen;
  const double tolerance = 1e-6 * stage.cycle_time;  // times are k Δt with rounding; samples lie far further apart
  const auto first = std::ranges::lower_bound(stage.time, stage.start_time - tolerance) - stage.time.begin();
  for (std::size_t k = static_cast<std::size_t>(first); k < values->size(); k += cycle_samples) {
    chosen.push_back((*values)[k]);
  }
  return make_numbers(std::move(chosen));
}

Figure make_orbit(Signals& signals, const std::string& joint) {
  Figure figure = make_pair_figure(signals, joint + ".x_offset", joint + ".y_offset");
  figure.id = joint + ".orbit";
  figure.kind = FigureKind::plane;
  figure.title = fmt::format("Orbit of the journal in {}", joint);
  for (const StageRecord& stage : signals.run().stages) {
    const JointWear* wear = find_wear(stage, joint);
    if (figure.curves.empty() || wear == nullptr || !std::isfinite(wear->bearing_radius)) continue;
    figure.curves.push_back(make_circle("clearance circle", wear->bearing_radius - wear->journal_radius));
    break;
  }
  figure.caption =
      "Journal centre from bearing centre, in the frame's axes. Outside the circle the unworn surfaces would touch.";
  figure.x = make_x_axis("Offset in x", "m", figure.curves);
  figure.y = make_y_axis("Offset in y", "m", figure.curves);
  // One scale for both axes needs one unit.
  figure.y.display_unit = figure.x.display_unit;
  figure.y.factor = figure.x.factor;
  return figure;
}

Figure make_phase_portrait(Signals& signals, const std::string& joint, const std::string& axis) {
  const std::string channel = fmt::format("{}.{}_offset", joint, axis);
  Figure figure = make_pair_figure(signals, channel, channel + "_rate");
  figure.id = fmt::format("{}.phase_{}", joint, axis);
  figure.kind = FigureKind::phase;
  figure.title = fmt::format("Phase portrait of {} in {}", joint, axis);
  figure.caption = "Journal against bearing: velocity over offset.";
  show_first_and_last(figure);
  figure.x = make_x_axis("Offset in " + axis, "m", figure.curves);
  figure.y = make_y_axis("Velocity in " + axis, "m/s", figure.curves);
  return figure;
}

Figure make_poincare_map(Signals& signals, const std::string& joint, const std::string& axis) {
  Figure figure = make_phase_portrait(signals, joint, axis);
  figure.id = fmt::format("{}.poincare_{}", joint, axis);
  figure.title = fmt::format("Poincaré map of {} in {}", joint, axis);
  figure.caption = "The phase portrait met once a cycle, at the start of each counted cycle.";
  for (FigureCurve& curve : figure.curves) {
    const StageRecord* stage = find_stage(signals.run(), curve.group);
    if (stage == nullptr || curve.cycle_samples == 0) continue;
    curve.x = select_cycle_starts(*stage, curve.x, curve.cycle_samples);
    curve.y = select_cycle_starts(*stage, curve.y, curve.cycle_samples);
    curve.cycle_samples = 0;
    curve.points = true;
  }
  figure.x = make_x_axis("Offset in " + axis, "m", figure.curves);
  figure.y = make_y_axis("Velocity in " + axis, "m/s", figure.curves);
  return figure;
}

}  // namespace

std::vector<Figure> make_journal_figures(Signals& signals) {
  std::vector<Figure> figures;
  // Joint beside joint, so that pictures of one kind stand together.
  const std::vector<std::string> joints = find_clearance_joints(signals.run());
  for (const std::string& joint : joints) figures.push_back(make_orbit(signals, joint));
  for (const auto make : {make_phase_portrait, make_poincare_map}) {
    for (const std::string& joint : joints) {
      for (const char* axis : {"x", "y"}) figures.push_back(make(signals, joint, axis));
    }
  }
  std::erase_if(figures, [](const Figure& figure) { return figure.curves.empty(); });
  return figures;
}

}  // namespace gudgeon
