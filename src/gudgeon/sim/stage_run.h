// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One stage: a mechanism run over its cycles on fixed surfaces, and everything that is kept of it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "gudgeon/results/checkpoint.h"
#include "gudgeon/sim/contact_history.h"
#include "gudgeon/sim/load_reach.h"
#include "gudgeon/sim/motion_integrator.h"
#include "gudgeon/sim/peak_detector.h"
#include "gudgeon/sim/run_pace.h"
#include "gudgeon/sim/stage_recorder.h"
#include "gudgeon/sim/wear_accumulator.h"

namespace gudgeon {

/// Runs the system over warm-up and counted cycles from time zero; samples, statistics, contacts and wear are those of
/// the counted cycles, the energy balance that of the whole.
class StageRun {
 public:
  /// Keeps references to both.
  StageRun(const System& system, const Study& study, double cycle_time, std::string name);
  StageRun(const System&&, const Study&, double, std::string) = delete;
  StageRun(const System&, const Study&&, double, std::string) = delete;
  StageRun(const StageRun&) = delete;  // the peak detector holds on to its recorder
  StageRun& operator=(const StageRun&) = delete;

  /// Has the samples handed over in blocks of that size; the record then holds those after the last block.
  void stream(std::size_t block_size, const std::function<void(const SampleBlock&)>& take);
  /// Takes checkpoints: after a step when `wanted`, which is then cleared, and where it is stopped. A stage by the
  /// stiff integrator is only saved where that starts anew: every now and then, and not where it is stopped.
  void save(std::atomic<bool>* wanted, std::function<void(Checkpoint)> take);
  /// Goes on from there, not from a start. Throws FileError when it cannot be one of this stage.
  void resume(const Checkpoint& checkpoint);
  /// progress is called about a hundred times with the share of the stage that is done.
  StageRecord run(const State& start, const std::stop_token& stop, const std::function<void(double)>& progress);

 private:
  using Clock = std::chrono::steady_clock;

  void begin(const State& start);
  void advance(const std::stop_token& stop);
  void take_step(double step_start, const std::stop_token& stop);
  void check_step();
  void stop_on_request();
  void take_checkpoint();
  void transfer(StateArchive& archive);
  void accumulate_wear();
  void close_touching();
  void open_contact(std::size_t contact);
  void note_contact_change(std::size_t contact);
  void stop_outside_slots();
  void stop_open();
  bool sample_until(double time, const std::stop_token& stop);
  void fail_step();
  void stop_without_end();
  [[nodiscard]] std::string explain_cost() const;
  void stop(const std::string& code, const std::string& reason);
  void fail(const std::string& code, const std::string& reason);
  bool fail_at_law_end();
  bool fail_jammed();
  [[nodiscard]] double find_wall_time() const;
  void finish();

  const Study& study_;
  MotionIntegrator motion_;
  const System& system_;  // the one that moves
  StageRecorder recorder_;
  ContactHistory history_;
  PeakDetector peaks_;
  std::vector<WearAccumulator> wear_;              // one a clearance joint
  std::vector<WearAccumulator::StepSample> step_;  // of one contact
  Workspace scratch_;
  StageRecord record_;
  RunPace pace_;
  LoadReach reach_;

  double warm_up_end_;  // [s]
  double end_;          // [s]
  double sample_step_;  // [s]
  std::size_t n_all_samples_;
  std::size_t n_samples_ = 0;
  std::vector<double> interpolated_;
  StageRecorder::Energies initial_energies_;
  bool is_sampled_ = true;  // up to the end of the last step
  bool is_resumed_ = false;
  double earlier_wall_time_ = 0.0;  // [s] before it was resumed
  Clock::time_point began_at_;      // later by the time that others took
  std::atomic<bool>* checkpoint_wanted_ = nullptr;
  std::function<void(Checkpoint)> take_checkpoint_;
};

}  // namespace gudgeon
