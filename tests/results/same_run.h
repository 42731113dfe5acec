// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A whole run as bytes: two runs are the same when theirs are.
#pragma once

#include <string>

#include "gudgeon/results/run_record.h"

namespace gudgeon::test {

/// Everything a run record holds, numbers to the last bit.
class RunBytes {
 public:
  explicit RunBytes(const RunRecord& run) {
    for (const std::string* text :
         {&run.model_file, &run.model_text, &run.case_name, &run.resolved_model, &run.program_version}) {
      add(*text);
    }
    for (const auto& [path, text] : run.overrides) {
      add(path);
      add(text);
    }
    for (const StageRecord& stage : run.stages) add(stage);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  void add_number(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  template <class... Numbers>
  void add_numbers(Numbers... numbers) {
    (add_number(numbers), ...);
  }
  void add(const std::string& text) {
    add_number(text.size());
    bytes_ += text;
  }
  void add(const std::vector<double>& values) {
    add_number(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
  }
  void add(const JointWear& w) {
    add(w.joint);
    add_numbers(w.bearing_radius, w.journal_radius, w.clearance, w.slot_length, w.width, w.archard_volume,
                w.removed_volume, w.sliding_distance, w.contact_time, w.impulse);
    for (const auto* depths :
         {&w.bearing_depth, &w.journal_depth, &w.bearing_depth_added, &w.journal_depth_added, &w.total_depth_added}) {
      add(*depths);
    }
  }
  void add(const StageRecord& stage) {
    add(stage.name);
    add(stage.message);
    add_numbers(static_cast<int>(stage.status), stage.start_time, stage.end_time, stage.cycle_time, stage.cycles);
    for (const Channel& channel : stage.channels) {
      for (const std::string* text : {&channel.name, &channel.symbol, &channel.unit, &channel.description}) add(*text);
    }
    add(stage.time);
    for (const auto& values : stage.values) add(values);
    for (const ChannelStatistics& s : stage.statistics) {
      add(s.channel);
      add_numbers(s.minimum, s.minimum_time, s.maximum, s.maximum_time, s.mean, s.rms);
    }
    for (const JointWear& wear : stage.wear) add(wear);
    for (const ContactEvent& e : stage.events) {
      add_numbers(e.joint, e.onset_time, e.duration, e.onset_speed, e.angle, e.peak_force, e.position, e.contact);
    }
    const EnergyBalance& l = stage.energy;
    add_numbers(l.initial_energy, l.kinetic, l.potential, l.elastic, l.driver_work, l.load_work, l.damper_loss,
                l.contact_damping, l.friction, l.surface_work, l.exchanged, l.load_reach);
    const SolverStatistics& s = stage.solver;
    add_numbers(s.evaluations, s.accepted_steps, s.rejected_steps, s.onsets, s.separations, s.projections,
                s.smallest_step, s.largest_step, s.closure_residual, s.wall_time);
  }

  std::string bytes_;
};

}  // namespace gudgeon::test
