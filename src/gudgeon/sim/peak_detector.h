// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics of a stage and the peaks of its contacts, taken at accepted steps and, for extremes, between them.
#pragma once

#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/sim/contact_history.h"
#include "gudgeon/sim/motion_integrator.h"
#include "gudgeon/sim/peak_search.h"
#include "gudgeon/sim/stage_recorder.h"
#include "gudgeon/sim/step_history.h"

namespace gudgeon {

/// Follows the watched channels and the normal force of every contact. Where one of them may have had an extreme within
/// the last two steps, the equations are evaluated there, at states of the steps' polynomials.
class PeakDetector {
 public:
  PeakDetector(const System& system, MotionEquations& equations, StageRecorder& recorder, ContactHistory& history);
  PeakDetector(const PeakDetector&) = delete;  // its search calls back
  PeakDetector& operator=(const PeakDetector&) = delete;

  /// The state from which on steps count.
  void begin(const MotionIntegrator& motion);
  /// The step just accepted; before a change of contact at its end is noted.
  void take_step(const MotionIntegrator& motion);

  void transfer(StateArchive& archive);

 private:
  void note_contact_modes();
  void begin_after_jump();
  void take_state(const MotionIntegrator& motion);
  void look_into_short_contacts(const MotionIntegrator& motion);
  void eval(double time, const std::vector<ContactMode>& contact_modes);
  void measure(double time, std::span<double> row);
  void read_row(const Workspace& workspace, const std::vector<ContactMode>& contact_modes, std::span<double> row);

  const System& system_;
  MotionEquations& equations_;  // of the motion
  StageRecorder& recorder_;
  ContactHistory& history_;
  StepHistory steps_;
  PeakSearch search_;
  Workspace scratch_;
  std::vector<double> y_;
  std::vector<double> slope_;
  std::vector<double> forces_;  // [N] of the contacts at the last step
  std::size_t n_watched_;       // channels, which stand before the contacts
};

}  // namespace gudgeon
