// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Attempts of the motion integrator, and how they are made to end where a contact changes.
#include <algorithm>
#include <cmath>

#include "gudgeon/sim/motion_integrator.h"

namespace gudgeon {

namespace {

// Onset is located this well [s]; the integrator stops within it, before the surfaces touch.
constexpr double kOnsetTime = 1e-10;
// Landing on a change takes one or two passes; bisection from the longest step to the shortest would take this many.
constexpr int kMostLandings = 50;

}  // namespace

// Tries a step and, when a contact changes within it, the part up to the change.
bool MotionIntegrator::attempt_step(double longest, double left) {
  if (!stepper_->attempt(longest, left)) return false;
  find_end_gaps();
  auto change = events_.find_first_change(stepper_->dense(), equations_.latches, gaps_, end_gaps_, scratch_);
  // Where a landing finds another gap closed that dense output of the longer step saw open, that one is landed on.
  for (std::size_t landing = 0; change; ++landing) {
    if (landing > gaps_.size() || !land_on_change(*change)) {
      stepper_->shorten();
      changing_contact_.reset();
      return false;
    }
    if (!is_gap_passed()) break;
    changing_contact_.reset();
    change = events_.find_first_change(stepper_->dense(), equations_.latches, gaps_, end_gaps_, scratch_);
  }
  return true;
}

// Whether a contact that is open, and has not just been landed on, penetrates at the end of the attempt.
bool MotionIntegrator::is_gap_passed() const {
  for (std::size_t k = 0; k < end_gaps_.size(); ++k) {
    if (changing_contact_ == k || equations_.latches[k].in_contact) continue;
    if (end_gaps_[k].penetration > 0.0) return true;
  }
  return false;
}

void MotionIntegrator::find_end_gaps() {
  if (stepper_->evaluates_end()) {
    events_.find_gaps(equations_.workspace, equations_.latches, end_gaps_);
  } else {
    events_.find_gaps(equations_.workspace, end_gaps_);
  }
}

// Ends the step again so as to end just on the near side of an onset, or just past a separation: within kOnsetTime of
// the change and with the gap open in both cases. Newton's method on the step's length, kept inside a bracket. A change
// that only dense output has seen, as where surfaces graze, is none: the step then ends where it was thought to be.
// False when the step was so long that the gap is past the change from its first moment on, going the other way, or
// when it cannot be ended there.
bool MotionIntegrator::land_on_change(const ContactChange& change) {
  const std::size_t k = change.contact;
  const double sign = equations_.latches[k].in_contact ? -1.0 : 1.0;
  const double whole = stepper_->dense().step();
  const double expected = std::clamp(change.share, 0.0, 1.0) * whole;
  double before = 0.0;
  double after = whole;
  bool passed = sign * end_gaps_[k].penetration > 0.0;
  double h = expected;
  for (int pass = 0; pass < kMostLandings; ++pass) {
    stepper_->end_at(h);
    find_end_gaps();
    const double penetration = end_gaps_[k].penetration;
    const double rate = end_gaps_[k].penetration_rate;
    if (!std::isfinite(penetration)) {
      after = h;
      h = 0.5 * (before + after);
      continue;
    }
    const double window = 0.5 * kOnsetTime * std::abs(rate);
    const double excess = penetration + window;
    const bool landed = std::abs(excess) <= window;
    passed = passed || landed || sign * excess > 0.0;
    if (landed || after - before <= kSmallestStep) break;
    (sign * excess > 0.0 ? after : before) = h;
    const double newton = h - excess / rate;
    h = newton > before && newton < after ? newton : 0.5 * (before + after);
  }
  if (passed) {
    if (!std::isfinite(end_gaps_[k].penetration)) return false;
    if (stepper_->dense().step() <= kSmallestStep && sign * end_gaps_[k].penetration_rate < 0.0) return false;
    changing_contact_ = k;
    return true;
  }
  stepper_->end_at(expected > kSmallestStep ? expected : whole);
  find_end_gaps();
  return std::isfinite(end_gaps_[k].penetration);
}

}  // namespace gudgeon
