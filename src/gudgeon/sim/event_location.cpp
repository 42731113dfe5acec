// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Attempts of the motion integrator, and how they are made to end where a contact changes.
#include <algorithm>
#include <cmath>

#include "gudgeon/sim/event_search.h"
#include "gudgeon/sim/motion_integrator.h"

namespace gudgeon {

namespace {

// A change is located within this share of the step: what the rates change by in that time is far below what a step may
// be off by, and Newton's second try is mostly nearer than that. Tighter tolerances than the default want it tighter.
constexpr double kWindow = 1e-9;
constexpr double kDefaultTolerance = 1e-6;
// A change that only dense output has seen ends its step where it was seen, unless that is next to nothing of the step.
constexpr double kLeastShare = 1e-6;

}  // namespace

// Tries a step and, when a contact changes within it, the part up to the change.
bool MotionIntegrator::attempt_step(double longest, double left) {
  if (!stepper_->attempt(longest, left) || !end_at_break() || !sees_loads()) return false;
  find_end_gaps();
  auto change = events_.find_first_change(stepper_->dense(), equations_.contact_modes, gaps_, end_gaps_, scratch_);
  // Where the located event finds another gap closed that dense output of the longer step saw open, that one is
  // located.
  for (std::size_t located = 0; change; ++located) {
    if (located > gaps_.size() || !locate_change(*change)) {
      stepper_->shorten();
      changing_contact_.reset();
      return false;
    }
    if (!is_gap_passed()) break;
    changing_contact_.reset();
    change = events_.find_first_change(stepper_->dense(), equations_.contact_modes, gaps_, end_gaps_, scratch_);
  }
  // Past the end of its slot a journal is found at the end of a step.
  if (const auto share = events_.find_hidden_overrun(stepper_->dense(), gaps_, end_gaps_, scratch_)) {
    changing_contact_.reset();
    stepper_->end_at(*share * stepper_->dense().step());
    find_end_gaps();
    if (!std::isfinite(end_gaps_.front().penetration)) {
      stepper_->shorten();
      return false;
    }
  }
  return true;
}

// Whether a contact that is open, and has not just been located, penetrates at the end of the attempt.
bool MotionIntegrator::is_gap_passed() const {
  for (std::size_t k = 0; k < end_gaps_.size(); ++k) {
    if (changing_contact_ == k || equations_.contact_modes[k].in_contact) continue;
    if (end_gaps_[k].penetration > 0.0) return true;
  }
  return false;
}

void MotionIntegrator::find_end_gaps() {
  if (stepper_->evaluates_end()) {
    events_.find_gaps(equations_.workspace, equations_.contact_modes, end_gaps_);
  } else {
    events_.find_gaps(equations_.workspace, end_gaps_);
  }
}

// Ends the step again so as to end just on the near side of an onset, or just past a separation: with the gap open in
// both cases. A change that only dense output has seen, as where surfaces graze, is none: the step then ends where it
// was thought to be. False when the step was so long that the gap is past the change from its first moment on, going
// the other way, or when it cannot be ended there.
bool MotionIntegrator::locate_change(const ContactChange& change) {
  const std::size_t k = change.contact;
  const bool is_onset = !equations_.contact_modes[k].in_contact;
  const double sign = is_onset ? 1.0 : -1.0;
  const auto watch = [&](const GapState& gap) {
    return WatchedValue{sign * gap.penetration, sign * gap.penetration_rate};
  };
  const double whole = stepper_->dense().step();
  const double expected = std::clamp(change.share, 0.0, 1.0) * whole;
  const double window_time = kWindow * std::min(1.0, study_.relative_tolerance / kDefaultTolerance) * whole;
  EventSearch search(is_onset ? EventSearch::Side::before : EventSearch::Side::past, whole, expected, watch(gaps_[k]),
                     watch(end_gaps_[k]));
  const auto end_at = [&](double h) {
    stepper_->end_at(h);
    find_end_gaps();
    return std::isfinite(end_gaps_[k].penetration);
  };
  for (bool goes_on = true; goes_on;) {
    if (!end_at(search.length())) {
      goes_on = search.note_failure();
      continue;
    }
    const double rounding = events_.find_gap_rounding(k, stepper_->dense().start_time(), equations_.workspace);
    const double window = std::max(window_time * std::abs(end_gaps_[k].penetration_rate), rounding);
    goes_on = search.note(watch(end_gaps_[k]), window);
  }
  switch (search.outcome()) {
    case EventSearch::Outcome::found:
      if (!search.is_current()) end_at(search.length());
      if (!std::isfinite(end_gaps_[k].penetration)) return false;
      changing_contact_ = k;
      return true;
    case EventSearch::Outcome::none:
      return end_at(expected > kLeastShare * whole ? expected : whole);
    default:
      return false;
  }
}

}  // namespace gudgeon
