// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Attempts of the motion integrator, and how they are made to end where a load goes to another piece.
#include <algorithm>
#include <cmath>

#include "gudgeon/sim/motion_integrator.h"

namespace gudgeon {

namespace {

// Location takes one or two passes; bisection from the longest step to the window would take this many.
constexpr int kMostPasses = 60;
// Where in the window past a break a step is aimed.
constexpr double kAim = 0.5;
// Singular positions are walked up to while a break lies as near as this share of the longest step.
constexpr double kNearestShare = 1e-3;
constexpr int kStrideLooks = 8;
// A step is not cut to less than this share of a cycle to end at a load's peak: it starts so near that it sees it.
constexpr double kShortestToPeak = 1e-9;

}  // namespace

// Ends the attempted step where the first load leaves its piece. False when it did so from the first moment on, or when
// the step cannot be ended there.
bool MotionIntegrator::end_at_break() {
  located_ = 0.0;
  is_out_of_piece_ = false;
  if (breaks_.empty()) return true;
  const auto leave = breaks_.find_first_leave(stepper_->dense(), equations_);
  if (!leave) return true;
  if (leave->share == 0.0) {
    is_out_of_piece_ = true;
    return false;
  }
  if (locate_break(*leave)) return true;
  stepper_->shorten();
  return false;
}

// False where a load has a narrow peak or flank within the attempted step that its stages have not seen: a step has to
// end there, so that its error tells.
bool MotionIntegrator::sees_loads() {
  if (unseen_.empty()) return true;
  const auto time = unseen_.find(stepper_->dense(), equations_);
  if (!time || *time - time_ <= kShortestToPeak * equations_.time_scale) return true;
  peak_time_ = *time;
  is_out_of_piece_ = false;
  stepper_->shorten();
  return false;
}

// Takes the step again to just past the break, within the window: by Newton's method on its length, in a bracket.
bool MotionIntegrator::locate_break(const LoadBreaks::Leave& leave) {
  const double start = stepper_->dense().start_time();
  const double whole = stepper_->dense().step();
  const double window = breaks_.find_window(start);
  double before = 0.0;
  double after = whole;
  double h = std::min(leave.share * whole + kAim * window, whole);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    if (h != stepper_->dense().step()) stepper_->end_at(h);
    const double excess = breaks_.find_excess(leave.watched, stepper_->dense(), equations_);
    if (!std::isfinite(excess) && !(excess < 0.0)) return false;
    const bool is_past = excess >= 0.0;
    if (is_past && (excess <= leave.rate * window || h - before <= window)) {
      located_ = h;
      return true;
    }
    (is_past ? after : before) = h;
    if (after - before <= window) {
      if (after == whole && !is_past) return true;  // dense output saw a break that the step does not come to
      h = after;
      before = std::max(before, after - window);
      continue;
    }
    const double newton = h - (excess - kAim * window * leave.rate) / leave.rate;
    h = newton > before && newton < after ? newton : 0.5 * (before + after);
  }
  return false;
}

// Goes on with the pieces that the motion goes into, in a step of no length.
bool MotionIntegrator::change_pieces() {
  changes_piece_ = false;
  if (!breaks_.hold(time_, y_, slope_, equations_)) {
    stall_ = breaks_.find_stall();
    return false;
  }
  next_point_ = breaks_.find_next_point(time_);
  if (breaks_.has_changed()) {
    continues_ = false;
    passage_.forget();
    stiffness_detector_.forget();
    contact_stiffness_detector_.forget();
  }
  last_step_ = 0.0;
  strode_ = false;
  return true;
}

// The attempt went wrong from its start on: takes other pieces there.
bool MotionIntegrator::retry_with_other_pieces() {
  is_out_of_piece_ = false;
  stepper_->take_over_start(*stepper_);
  if (!change_pieces()) return false;
  stepper_->begin(time_, y_, slope_, false);
  continues_ = true;
  return true;
}

// Whether a break lies within a stride over a singular position, so that it is walked up to instead. One right beside
// the position is strode over, too; the pieces are chosen anew behind it.
bool MotionIntegrator::passes_break(double far_side) {
  if (breaks_.empty() || far_side - time_ <= kNearestShare * longest_step_) return false;
  if (next_point_ < far_side) return true;
  for (int k = 1; k <= kStrideLooks; ++k) {
    const double t = time_ + (far_side - time_) * k / kStrideLooks;
    passage_.interpolate(t, passed_);
    if (!breaks_.is_inside(t, passed_, equations_)) return true;
  }
  return false;
}

}  // namespace gudgeon
