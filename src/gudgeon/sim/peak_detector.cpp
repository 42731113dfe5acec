// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From steps to rows of signals.
#include "gudgeon/sim/peak_detector.h"

#include <algorithm>

namespace gudgeon {

PeakDetector::PeakDetector(const System& system, MotionEquations& equations, StageRecorder& recorder,
                           ContactHistory& history)
    : system_(system),
      equations_(equations),
      recorder_(recorder),
      history_(history),
      steps_(equations),
      search_(recorder.watched_row().size() + system.tables.contacts.size(),
              [this](double time, std::span<double> row) { measure(time, row); }),
      scratch_(system.tables),
      y_(equations.n_states()),
      slope_(equations.n_states()),
      forces_(system.tables.contacts.size(), 0.0),
      n_watched_(recorder.watched_row().size()) {}

void PeakDetector::begin(const MotionIntegrator& motion) {
  steps_.clear();
  search_.interrupt();
  take_state(motion);
}

void PeakDetector::take_step(const MotionIntegrator& motion) {
  // A stride has no stages; two contacts that change at one instant have no time between.
  if (motion.last_step() == 0.0) {
    begin(motion);
    return;
  }
  note_contact_modes();
  take_state(motion);
  look_into_short_contacts(motion);
}

void PeakDetector::transfer(StateArchive& archive) {
  scratch_.fit(system_.tables);
  archive(steps_, search_, scratch_, y_, slope_, forces_);
}

// What has changed at the start of the step.
void PeakDetector::note_contact_modes() {
  const std::vector<ContactMode>& before = steps_.contact_modes();
  bool jumps = false;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (before[k].in_contact == equations_.contact_modes[k].in_contact) continue;
    jumps = jumps || system_.tables.contacts[k].steps_at_onset || system_.tables.contacts[k].bristle >= 0;
    search_.forget(n_watched_ + k);
  }
  if (jumps) begin_after_jump();
}

// Forces may have changed with the contact modes: the state stands once more, as the step began with it.
void PeakDetector::begin_after_jump() {
  const double time = steps_.time(0);
  std::ranges::copy(steps_.state(0), y_.begin());
  eval(time, equations_.contact_modes);
  const std::size_t n_free = equations_.n_free();
  for (std::size_t i = 0; i < n_free; ++i) {
    slope_[i] = y_[n_free + i];
    slope_[n_free + i] = scratch_.equations[i];
  }
  for (std::size_t k = 0; k < system_.tables.contacts.size(); ++k) {
    if (system_.tables.contacts[k].bristle < 0) continue;
    slope_[equations_.bristle_at(k)] = scratch_.contact_forces[k].bristle_rate;
  }
  steps_.clear();
  search_.interrupt();
  steps_.note(time, y_, slope_, equations_.contact_modes);
  recorder_.watch(time, scratch_);
  read_row(scratch_, equations_.contact_modes, search_.next_row());
  search_.take(time);
}

void PeakDetector::take_state(const MotionIntegrator& motion) {
  steps_.note(motion.time(), motion.y(), motion.slope(), equations_.contact_modes);
  recorder_.watch(motion.time(), equations_.workspace, motion.gaps());
  read_row(equations_.workspace, equations_.contact_modes, search_.next_row());
  search_.take(motion.time());
}

// A contact that opens in the step in which it closed shows no force at either end.
void PeakDetector::look_into_short_contacts(const MotionIntegrator& motion) {
  const std::span<const double> nodes = motion.stepper().nodes();
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const double before = forces_[k];
    forces_[k] = equations_.workspace.contact_forces[k].normal_force;
    if (!equations_.contact_modes[k].in_contact || before > 0.0 || forces_[k] > 0.0) continue;
    double greatest = 0.0;
    std::size_t at = 0;
    for (std::size_t stage = 0; stage < nodes.size(); ++stage) {
      const double force = motion.find_sample(static_cast<int>(stage), k).normal_force;
      if (force > greatest) greatest = force, at = stage;
    }
    if (greatest > 0.0) search_.look_between(steps_.time(1) + nodes[at] * motion.last_step(), n_watched_ + k);
  }
}

void PeakDetector::eval(double time, const std::vector<ContactMode>& contact_modes) {
  scratch_.fit(system_.tables);
  scratch_.loads.held = equations_.workspace.loads.held;  // the same in all steps since the detector began
  equations_.eval_in(time, y_.data(), contact_modes, scratch_);
}

void PeakDetector::measure(double time, std::span<double> row) {
  steps_.interpolate(time, y_.data());
  const std::vector<ContactMode>& contact_modes = steps_.find_contact_modes(time);
  eval(time, contact_modes);
  recorder_.watch_between(time, scratch_);
  read_row(scratch_, contact_modes, row);
}

void PeakDetector::read_row(const Workspace& workspace, const std::vector<ContactMode>& contact_modes,
                            std::span<double> row) {
  std::ranges::copy(recorder_.watched_row(), row.begin());
  for (std::size_t k = 0; k < contact_modes.size(); ++k) {
    const double force = contact_modes[k].in_contact ? workspace.contact_forces[k].normal_force : 0.0;
    if (contact_modes[k].in_contact) history_.watch(k, force);
    row[n_watched_ + k] = force;
  }
}

}  // namespace gudgeon
