// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The time loop: one stage of a mechanism on fixed surfaces.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "gudgeon/model/study.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/sim/closure_projection.h"
#include "gudgeon/sim/contact_events.h"
#include "gudgeon/sim/contact_history.h"
#include "gudgeon/sim/dormand_prince.h"
#include "gudgeon/sim/motion_equations.h"
#include "gudgeon/sim/singular_passage.h"
#include "gudgeon/sim/stage_recorder.h"
#include "gudgeon/sim/step_control.h"
#include "gudgeon/sim/wear_deposit.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

/// Runs the system over warm-up and counted cycles from time zero.
///
/// Steps are controlled by their local error. A contact's change ends its step: onset is located to kOnsetTime, just
/// before the surfaces touch, and its speed latched. Loop closures are projected when they need it. Nothing is allocated
/// between samples and events.
class StageRun {
 public:
  StageRun(const System& system, const Study& study, double cycle_time, std::string name);

  /// progress is called about a hundred times with the share of the stage that is done.
  StageRecord run(const State& start, const std::stop_token& stop, const std::function<void(double)>& progress);

 private:
  void begin(const State& start);
  bool advance();
  bool attempt_step(double h);
  void land_on_change(const ContactChange& change);
  void attempt(double h);
  void accept();
  void project();
  void change_contact(std::size_t contact);
  void deposit_wear();
  bool pass_singular_position();
  template <class Interpolate>
  void sample_until(double time, Interpolate&& interpolate);
  void interpolate_step(double time);
  void watch_contacts();
  double next_milestone() const;
  void fail(const std::string& reason);
  void finish();

  const System& system_;
  const Study& study_;
  MotionEquations equations_;
  DormandPrince stepper_;
  StepControl control_;
  ClosureProjection projection_;
  SingularPassage passage_;
  ContactEvents events_;
  StageRecorder recorder_;
  Workspace scratch_;
  std::vector<WearDeposit> wear_;
  StageRecord record_;

  double warm_up_end_;   // [s]
  double end_;           // [s]
  double sample_step_;   // [s]
  std::int64_t n_samples_ = 0;
  double time_ = 0.0;
  std::optional<std::size_t> pending_change_;  // contact that changes at the end of the step
  std::vector<double> y_;
  std::vector<double> slope_;
  std::vector<double> interpolated_;
  std::vector<GapState> gaps_;      // at the start of the step
  std::vector<GapState> end_gaps_;
  std::vector<std::vector<ContactSample>> samples_;  // samples_[stage][contact]
  ContactHistory history_;
  StageRecorder::Energies initial_energies_;
};

}  // namespace gudgeon
