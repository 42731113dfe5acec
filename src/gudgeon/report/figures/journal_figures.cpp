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
  curve.line = LineStyle::dashed;
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

/// A coordinate of a journal in its bearing, and its rate.
struct JournalAxis {
  const char* id;  ///< of the figure, "x"
  const char* place;
  const char* rate;
  const char* words;  ///< "in x"
  const char* label;
  const char* unit;
  const char* rate_label;
  const char* rate_unit;
};

constexpr JournalAxis kJournalAxes[] = {
    {"x", "x_offset", "x_offset_rate", "in x", "Offset in x", "m", "Velocity in x", "m/s"},
    {"y", "y_offset", "y_offset_rate", "in y", "Offset in y", "m", "Velocity in y", "m/s"},
    {"along", "displacement", "speed", "along its slot", "Place along the slot", "m", "Speed along the slot", "m/s"},
    {"across", "height", "height_rate", "across its slot", "Height in the slot", "m", "Speed across the slot", "m/s"},
    {"tilt", "tilt", "tilt_rate", "in tilt", "Tilt", "rad", "Rate of tilt", "rad/s"},
};

const JointWear* find_any_wear(const RunRecord& run, const std::string& joint) {
  for (const StageRecord& stage : run.stages) {
    if (const JointWear* wear = find_wear(stage, joint)) return wear;
  }
  return nullptr;
}

Figure make_orbit(Signals& signals, const std::string& joint) {
  Figure figure = make_pair_figure(signals, joint + ".x_offset", joint + ".y_offset");
  if (figure.curves.empty()) return figure;
  figure.id = joint + ".orbit";
  figure.kind = FigureKind::plane;
  figure.title = fmt::format("Orbit of the journal in {}", joint);
  if (const JointWear* wear = find_any_wear(signals.run(), joint)) {
    figure.curves.push_back(make_circle("clearance circle", wear->bearing_radius - wear->journal_radius));
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

/// How far a middle may go to either side, over the whole slot.
FigureCurve make_wall(double slot_length, double height) {
  FigureCurve curve;
  curve.name = "clearance";
  curve.line = LineStyle::dashed;
  curve.x = make_numbers({-0.5 * slot_length, 0.5 * slot_length});
  curve.y = make_numbers({height, height});
  return curve;
}

/// The orbit of a block or pin: its middle between the sides of its slot.
Figure make_slot_path(Signals& signals, const std::string& joint) {
  Figure figure = make_pair_figure(signals, joint + ".displacement", joint + ".height");
  if (figure.curves.empty()) return figure;
  figure.id = joint + ".orbit";
  figure.kind = FigureKind::phase;
  figure.title = fmt::format("Path of the journal in the slot of {}", joint);
  if (const JointWear* wear = find_any_wear(signals.run(), joint)) {
    for (const double side : {1.0, -1.0}) figure.curves.push_back(make_wall(wear->slot_length, side * wear->clearance));
  }
  figure.caption =
      "Middle of the journal from the middle of the slot, heights magnified. Beyond a dashed line the unworn surfaces "
      "would touch; a tilted block touches before its middle is there.";
  figure.x = make_x_axis("Place along the slot", "m", figure.curves);
  figure.y = make_y_axis("Height in the slot", "m", figure.curves);
  return figure;
}

Figure make_phase_portrait(Signals& signals, const std::string& joint, const JournalAxis& axis) {
  Figure figure =
      make_pair_figure(signals, fmt::format("{}.{}", joint, axis.place), fmt::format("{}.{}", joint, axis.rate));
  figure.id = fmt::format("{}.phase_{}", joint, axis.id);
  figure.kind = FigureKind::phase;
  figure.title = fmt::format("Phase portrait of {} {}", joint, axis.words);
  figure.caption = "Journal against bearing: velocity over offset.";
  show_first_and_last(figure);
  figure.x = make_x_axis(axis.label, axis.unit, figure.curves);
  figure.y = make_y_axis(axis.rate_label, axis.rate_unit, figure.curves);
  return figure;
}

Figure make_poincare_map(Signals& signals, const std::string& joint, const JournalAxis& axis) {
  Figure figure = make_phase_portrait(signals, joint, axis);
  figure.id = fmt::format("{}.poincare_{}", joint, axis.id);
  figure.title = fmt::format("Poincaré map of {} {}", joint, axis.words);
  figure.caption = "The phase portrait met once a cycle, at the start of each counted cycle.";
  for (FigureCurve& curve : figure.curves) {
    const StageRecord* stage = find_stage(signals.run(), curve.group);
    if (stage == nullptr || curve.cycle_samples == 0) continue;
    curve.x = select_cycle_starts(*stage, curve.x, curve.cycle_samples);
    curve.y = select_cycle_starts(*stage, curve.y, curve.cycle_samples);
    curve.cycle_samples = 0;
    curve.points = true;
  }
  figure.x = make_x_axis(axis.label, axis.unit, figure.curves);
  figure.y = make_y_axis(axis.rate_label, axis.rate_unit, figure.curves);
  return figure;
}

}  // namespace

std::vector<Figure> make_journal_figures(Signals& signals) {
  std::vector<Figure> figures;
  // Joint beside joint, so that pictures of one kind stand together.
  const std::vector<std::string> joints = find_clearance_joints(signals.run());
  for (const auto make : {make_orbit, make_slot_path}) {
    for (const std::string& joint : joints) figures.push_back(make(signals, joint));
  }
  for (const auto make : {make_phase_portrait, make_poincare_map}) {
    for (const std::string& joint : joints) {
      for (const JournalAxis& axis : kJournalAxes) figures.push_back(make(signals, joint, axis));
    }
  }
  std::erase_if(figures, [](const Figure& figure) { return figure.curves.empty(); });
  return figures;
}

}  // namespace gudgeon
