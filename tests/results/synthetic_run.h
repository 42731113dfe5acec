// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A made-up run with round numbers: a slider along x and a clearance joint A, ideal, unworn and worn once.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "gudgeon/results/run_record.h"

namespace gudgeon::test {

inline constexpr std::size_t kSamples = 201;  // two cycles of 1 s
inline constexpr std::size_t kCells = 100;

/// x = amplitude sin(2π t) and its rates, plus the lag of a loose joint.
inline void add_slider(StageRecord& stage, double amplitude, double lag) {
  stage.channels = {{"slider.x", "x", "m", "position along the guide"},
                    {"slider.x_velocity", "ẋ", "m/s", "speed along the guide"},
                    {"slider.x_acceleration", "ẍ", "m/s^2", "acceleration along the guide"},
                    {"slider.angle_rate", "θ̇", "rad/s", "never turns"},
                    {"crank.angle_rate", "θ̇", "rad/s", "constant"},
                    {"crank.effort", "τ", "N m", "torque of the driver"}};
  stage.values.resize(stage.channels.size());
  const double w = 2.0 * std::numbers::pi;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double t = 0.01 * static_cast<double>(i);
    stage.time.push_back(t);
    stage.values[0].push_back(amplitude * std::sin(w * t) + lag);
    stage.values[1].push_back(amplitude * w * std::cos(w * t));
    stage.values[2].push_back(-amplitude * w * w * std::sin(w * t));
    stage.values[3].push_back(0.0);
    stage.values[4].push_back(w);
    stage.values[5].push_back(-52.33 * std::cos(w * t));
  }
  const double a = amplitude * w * w;
  stage.statistics = {{"slider.x_acceleration", -a, 0.25, a, 0.75, 0.0, a / std::numbers::sqrt2},
                      {"slider.angle_rate", 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                      {"crank.effort", -52.33, 0.0, 52.33, 0.5, 0.0, 37.0}};
}

/// One clearance joint: a scar over the angle 0 and its contacts.
inline void add_joint(StageRecord& stage, double depth, double peak_force) {
  stage.channels.push_back({"A.normal_force", "F_n", "N", "contact force"});
  stage.values.emplace_back(kSamples, 0.0);
  stage.values.back()[5] = peak_force;
  stage.statistics.push_back({"A.normal_force", 0.0, 0.0, peak_force, 0.05, 20.0, 120.0});

  JointWear& wear = stage.wear.emplace_back();
  wear.joint = "A";
  wear.bearing_radius = 15e-3;
  wear.journal_radius = 14.5e-3;
  wear.clearance = 0.5e-3;
  wear.width = 20e-3;
  wear.bearing_depth.assign(kCells, 0.0);
  wear.journal_depth.assign(kCells, 0.0);
  wear.bearing_depth_added.assign(kCells, 0.0);
  wear.journal_depth_added.assign(kCells, depth / static_cast<double>(2 * kCells));
  wear.total_depth_added.assign(kCells, 0.0);
  for (const std::size_t k : {95, 96, 97, 98, 99, 0, 1, 2, 3, 4}) {
    wear.bearing_depth_added[k] = k == 97 ? 0.5 * depth : 0.25 * depth;
    wear.total_depth_added[k] = k == 97 ? depth : 0.5 * depth;
  }
  wear.archard_volume = 3.0e-9;
  wear.removed_volume = 3.0e-9;
  wear.sliding_distance = 1.5;
  wear.contact_time = 0.6;
  wear.impulse = 60.0;
  stage.events = {{0, 0.05, 0.5, 0.12, -1.0, peak_force, 0.0, 0},
                  {0, 0.70, 0.005, 0.30, 2.0, 0.5 * peak_force, -0.02, 3},
                  {0, 1.00, 0.095, 0.01, 2.5, 100.0, 0.0, 0}};
}

inline StageRecord make_stage(const std::string& name) {
  StageRecord stage;
  stage.name = name;
  stage.end_time = 2.0;
  stage.cycle_time = 1.0;
  stage.cycles = 2;
  stage.energy = {1.0, 1.5, 0.25, 0.0, 12.0, -2.5, 1.75, 5.0, 2.0, 0.0, 23.25};
  stage.solver = {1234567, 200000, 345, 3, 3, 200000, 1e-9, 1e-3, 1e-15, 2.5};
  return stage;
}

/// "ideal", "no_wear" and "wear_1".
inline RunRecord make_run() {
  RunRecord run{"press.toml", "[mechanism]\nname = \"Presse für µm\"\n", "base", {}, "resolved\n", "0.1.0", {}};
  run.overrides = {{"joints.A.radial_clearance", "0.3 mm"}, {"study.cycles", "2"}};
  run.stages = {make_stage("ideal"), make_stage("no_wear"), make_stage("wear_1")};
  for (StageRecord& stage : run.stages) add_slider(stage, 0.1, stage.name == "ideal" ? 0.0 : 2e-4);
  add_joint(run.stages[1], 4e-6, 2000.0);
  add_joint(run.stages[2], 6e-6, 2500.0);
  return run;
}

/// The values that text and arithmetic lose most easily.
inline std::vector<double> make_hard_values() {
  using limits = std::numeric_limits<double>;
  return {0.0,
          -0.0,
          0.1,
          1.0 / 3.0,
          limits::denorm_min(),
          limits::max(),
          -limits::infinity(),
          limits::quiet_NaN(),
          std::nextafter(1.0, 2.0)};
}

}  // namespace gudgeon::test
