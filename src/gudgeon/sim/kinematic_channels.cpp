// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Names and values beside those of a run, in one order.
#include "gudgeon/sim/kinematic_channels.h"

#include <algorithm>
#include <array>

#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

namespace {

// Work and losses need an integration over time; the other energies stay.
void drop_integrals(StageRecord& stage) {
  for (std::size_t k = stage.channels.size(); k-- > 0;) {
    const std::string& name = stage.channels[k].name;
    if (!name.starts_with("energy.") || name == "energy.kinetic" || name == "energy.potential") continue;
    const auto at = static_cast<std::ptrdiff_t>(k);
    stage.channels.erase(stage.channels.begin() + at);
    stage.values.erase(stage.values.begin() + at);
  }
}

void take_statistics(StageRecord& stage) {
  std::vector<std::string> names;
  for (const Channel& channel : stage.channels) names.push_back(channel.name);
  StatisticsAccumulator statistics(names);
  std::vector<double> row(names.size());
  for (std::size_t i = 0; i < stage.time.size(); ++i) {
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = stage.values[k][i];
    statistics.update(stage.time[i], row);
  }
  stage.statistics = statistics.summarize();
}

std::vector<Channel> list_channels(const KinematicSolver& solver) {
  const Mechanism& mechanism = solver.system().mechanism;
  std::vector<Channel> channels;
  for (const Joint& joint : mechanism.joints) {
    if (!has_line(joint.kind)) continue;
    channels.push_back({joint.name + ".displacement", "s", "m", "Second point along the joint's line"});
    channels.push_back({joint.name + ".speed", "ṡ", "m/s", "Its speed, seen from the first body"});
    channels.push_back({joint.name + ".acceleration", "s̈", "m/s^2", "Its acceleration, seen from the first body"});
  }
  for (const Driver& driver : mechanism.drivers) {
    const bool turns = std::holds_alternative<DrivenAngle>(driver.target);
    channels.push_back({driver.name + ".value", turns ? "φ" : "s", turns ? "rad" : "m", "What the driver prescribes"});
  }
  for (const LoopFold& fold : solver.folds().folds()) {
    if (!fold.is_dyad) continue;
    const bool guide = solver.folds().has_guide(fold);
    channels.push_back({name_transmission(solver, fold), guide ? "α" : "μ", "rad",
                        guide ? "Between link and guide" : "Between the two links that close the loop"});
  }
  return channels;
}

}  // namespace

std::string name_transmission(const KinematicSolver& solver, const LoopFold& fold) {
  const System& system = solver.system();
  return system.mechanism.joints[system.tables.closures[fold.closure].joint].name +
         (solver.folds().has_guide(fold) ? ".pressure_angle" : ".transmission_angle");
}

KinematicChannels::KinematicChannels(KinematicSolver& solver, MotionProbe& probe)
    : solver_(&solver),
      probe_(&probe),
      recorder_(solver.system()),
      channels_(list_channels(solver)),
      values_(channels_.size()) {}

void KinematicChannels::sample() {
  const std::array<double, kEnergyIntegrals> no_integrals{};
  recorder_.sample(solver_->point().time, solver_->workspace(), {}, 0.0, no_integrals.data());
  const Mechanism& mechanism = solver_->system().mechanism;
  std::size_t next = 0;
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    if (!has_line(mechanism.joints[j].kind)) continue;
    const SlideMotion slide = probe_->find_slide(static_cast<int>(j));
    for (const double value : {slide.displacement, slide.speed, slide.acceleration}) values_[next++].push_back(value);
  }
  for (std::size_t d = 0; d < mechanism.drivers.size(); ++d) {
    values_[next++].push_back(probe_->find_driver_value(static_cast<int>(d)));
  }
  for (const LoopFold& fold : solver_->folds().folds()) {
    if (fold.is_dyad) values_[next++].push_back(probe_->find_transmission(fold));
  }
}

void KinematicChannels::finish(StageRecord& stage) {
  recorder_.finish(stage);
  drop_integrals(stage);
  stage.channels.insert(stage.channels.end(), channels_.begin(), channels_.end());
  for (std::vector<double>& values : values_) stage.values.push_back(std::move(values));
  take_statistics(stage);
}

}  // namespace gudgeon
