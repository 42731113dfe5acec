// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Brackets, tops, turns.
#include "gudgeon/sim/event_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gudgeon {

namespace {

// One or two tries most often; bisection down to rounding takes as many as there are bits.
constexpr int kMostTries = 60;
// Brackets are narrowed down to this share of the longest step: a few roundings.
constexpr double kNarrow = 4.0 * std::numeric_limits<double>::epsilon();

}  // namespace

EventSearch::EventSearch(Side side, double longest, double expected, WatchedValue start, WatchedValue end)
    : side_(side),
      longest_(longest),
      expected_(std::clamp(expected, 0.0, longest)),
      start_(start),
      h_(expected_),
      at_before_(start),
      past_(longest),
      at_past_(end),
      passed_(end.value > 0.0) {}

// Whether such an end lies past the change, or past a top below it.
bool EventSearch::is_past(const WatchedValue& end, double target) const {
  const bool begins_above = start_.value >= 0.0 && start_.rate < 0.0;
  if (end.value > target) return end.rate >= 0.0 || !begins_above;
  if (end.rate >= 0.0) return false;
  // Below and falling: either it has yet to turn, or it has been over a top.
  return h_ >= expected_ || (before_ > 0.0 && at_before_.rate > 0.0);
}

bool EventSearch::note(WatchedValue end, double window) {
  ++n_tries_;
  is_current_ = true;
  const double target = side_ == Side::before ? -window : window;
  const bool begins_above = start_.value >= 0.0 && start_.rate < 0.0;
  // What began a hair above zero and never came below need not be nearer than it was.
  const double hair = begins_above && side_ == Side::past ? std::max(window, start_.value) : window;
  const bool is_near = target < 0.0 ? std::abs(end.value - target) <= window : std::abs(end.value - hair) <= hair;
  if (is_near && end.rate >= 0.0) {
    outcome_ = Outcome::found;
    return false;
  }
  if (is_past(end, target)) {
    has_top_ = end.value <= target;
    passed_ = passed_ || !has_top_ || is_near;
    past_ = h_;
    at_past_ = end;
  } else {
    before_ = h_;
    at_before_ = end;
  }
  if (has_top_ && at_before_.rate >= 0.0) {
    // The quantity bends down in between: nowhere is it above the tangent.
    if (!passed_ && at_before_.value + at_before_.rate * (past_ - before_) < target - window) return settle();
    return go_on(before_ + (past_ - before_) * at_before_.rate / (at_before_.rate - at_past_.rate));
  }
  return go_on(h_ - (end.value - target) / end.rate);
}

bool EventSearch::note_failure() {
  ++n_tries_;
  past_ = h_;
  return go_on(0.5 * (before_ + past_));
}

bool EventSearch::go_on(double proposal) {
  if (past_ - before_ <= kNarrow * longest_ || n_tries_ >= kMostTries) return settle();
  h_ = proposal > before_ && proposal < past_ ? proposal : 0.5 * (before_ + past_);
  is_current_ = false;
  return true;
}

// The bracket is as narrow as it gets. A step without length is at a change that was there from the start, unless the
// quantity moves off it.
bool EventSearch::settle() {
  const double end = side_ == Side::before ? before_ : past_;
  const WatchedValue& there = side_ == Side::before ? at_before_ : at_past_;
  if (passed_ && !has_top_) {
    outcome_ = end <= kNarrow * longest_ && there.rate < 0.0 ? Outcome::impossible : Outcome::found;
  }
  is_current_ = h_ == end;
  h_ = end;
  return false;
}

}  // namespace gudgeon
