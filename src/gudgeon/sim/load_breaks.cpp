// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is watched, which pieces are held, and when a motion slides between two of them.
#include "gudgeon/sim/load_breaks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gudgeon/system/load_forces.h"

namespace gudgeon {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A change of piece is found to this share of a cycle, or to what rounding leaves of the time.
constexpr double kWindowShare = 1e-11;
constexpr double kRoundings = 8.0;
// A landing ends within the window past a break; this many windows ahead the motion is in the next piece. Where that
// turns out wrong, as where an argument creeps, it looks ten times farther each time.
constexpr double kWindowsAhead = 4.0;
constexpr double kFarther = 10.0;
constexpr int kMostStalls = 6;
// Where so many changes in a row fall within this share of a cycle, as about a speed that comes to rest under a force
// that vanishes with it, nothing is held for a while, and the step control sees what there is to see; for longer each
// time that follows on the last.
constexpr double kCrowdShare = 1e-6;
constexpr double kFirstReleaseShare = 1e-3;
constexpr double kLongestReleaseShare = 0.1;
// Of two breaks that change together, the second stays on its break, too, where it moves this much slower.
constexpr double kStaysOn = 1e-3;

}  // namespace

LoadBreaks::LoadBreaks(const System& system, double cycle_time, SolverStatistics& statistics)
    : system_(&system), statistics_(&statistics), cycle_time_(cycle_time), scratch_(system.tables) {
  watch_loads(system);
  watch_motions(system);
  arguments_.assign(watched_.size(), 0.0);
  excess_.assign(watched_.size() * (kParts + 1), 0.0);
  state_.assign(2 * static_cast<std::size_t>(system.tables.counts.n_free()) +
                    static_cast<std::size_t>(system.tables.n_bristles) + kEnergyIntegrals,
                0.0);
  for (Pieces& pieces : tried_) pieces.assign(scratch_.loads.breaks.size(), kFreePiece);
  next_ = tried_.front();
  later_slope_ = state_;
  recent_.fill(-kInfinity);
  released_until_ = -kInfinity;
  last_ = scratch_.loads.held;
}

void LoadBreaks::eval(double t, const std::vector<double>& y, std::vector<double>& slope,
                      MotionEquations& equations) noexcept {
  ++statistics_->evaluations;
  equations.eval(t, y.data(), slope.data());
}

void LoadBreaks::watch_loads(const System& system) {
  const LoadTables& loads = system.tables.loads;
  for (std::size_t k = 0; k < scratch_.loads.breaks.size(); ++k) {
    watched_.push_back({Kind::formula, k, -kInfinity, kInfinity});
  }
  if (!watched_.empty()) watched_.push_back({Kind::share, 0, -kInfinity, kInfinity});
  const auto watch = [&](const LoadFunction& function) {
    if (function.curve < 0) return;
    const Curve& curve = loads.curves[static_cast<std::size_t>(function.curve)];
    if (loads.channels[static_cast<std::size_t>(function.channel)].quantity == StateChannel::Quantity::time) {
      clocks_.push_back(curve);
      return;
    }
    watched_.push_back({Kind::curve, curves_.size(), -kInfinity, kInfinity});
    curves_.push_back({&curve, function.channel});
  };
  for (const ForceLoad& force : loads.forces) watch(force.x), watch(force.y);
  for (const TorqueLoad& torque : loads.torques) watch(torque.torque);
}

void LoadBreaks::watch_motions(const System& system) {
  for (const DrivenMotion& driven : system.tables.driven) {
    if (const auto* curve = std::get_if<SampledCurve>(&driven.motion)) {
      clocks_.push_back(make_motion_curve(*curve));
    } else if (const auto* expression = std::get_if<Expression>(&driven.motion)) {
      ExpressionEvaluator evaluator(expression->text, expression->constants, {"t"});
      const std::size_t first = motion_states_.size();
      for (std::size_t k = 0; k < evaluator.breaks().size(); ++k) {
        watched_.push_back({Kind::motion, first + k, -kInfinity, kInfinity});
      }
      motion_states_.resize(first + evaluator.breaks().size());
      motions_.push_back({std::move(evaluator), first});
    }
  }
  motion_pieces_.assign(motion_states_.size(), kFreePiece);
}

double LoadBreaks::find_next_point(double time) const noexcept {
  double next = kInfinity;
  if (released_until_ > time + find_window(time)) next = released_until_;
  for (const Curve& curve : clocks_) next = std::min(next, curve.find_piece(time + find_window(time)).second);
  return next;
}

double LoadBreaks::find_window(double time) const noexcept {
  return kWindowShare * cycle_time_ + kRoundings * std::numeric_limits<double>::epsilon() * std::abs(time);
}

bool LoadBreaks::hold(double t, const std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations) {
  if (watched_.empty()) return true;
  n_stalls_ = t - held_at_ <= kWindowsAhead * find_window(t) && held_at_ >= 0.0 ? n_stalls_ + 1 : 0;
  held_at_ = t;
  ahead_ = kWindowsAhead * find_window(t) * std::pow(kFarther, n_stalls_);
  ++n_changes_;
  has_changed_ = false;
  if (n_stalls_ > kMostStalls) return false;
  if (is_crowded(t)) {
    release(t, y, slope, equations);
    return true;
  }
  if (!scratch_.loads.breaks.empty()) {
    const HeldPieces& held = equations.workspace.loads.held;
    last_ = held;
    const bool slides = held.surface >= 0;
    if (!(slides && leave_slide(t, y, slope, equations)) && !choose_pieces(t, y, slope, equations)) return false;
    eval(t, y, slope, equations);
    has_changed_ = held.surface != last_.surface || held.pieces != last_.pieces || held.others != last_.others;
  }
  bound_pieces(t, y, slope, equations);
  return true;
}

// Whether changes follow each other closely; notes this one.
bool LoadBreaks::is_crowded(double t) noexcept {
  double& oldest = recent_[static_cast<std::size_t>(n_changes_) % recent_.size()];
  const bool crowded = t - oldest < kCrowdShare * cycle_time_;
  oldest = t;
  return crowded;
}

// Holds nothing for a while.
void LoadBreaks::release(double t, const std::vector<double>& y, std::vector<double>& slope,
                         MotionEquations& equations) noexcept {
  const bool follows = t - released_until_ < release_;
  release_ = follows ? std::min(2.0 * release_, kLongestReleaseShare * cycle_time_) : kFirstReleaseShare * cycle_time_;
  released_until_ = t + release_;
  recent_.fill(-kInfinity);
  HeldPieces& held = equations.workspace.loads.held;
  std::ranges::fill(held.pieces, kFreePiece);
  std::ranges::fill(held.others, kFreePiece);
  held.surface = -1;
  held.share = 0.0;
  for (Watched& watched : watched_) watched.low = -kInfinity, watched.high = kInfinity;
  is_searched_ = false;
  has_changed_ = true;
  eval(t, y, slope, equations);
}

void LoadBreaks::move_ahead(const std::vector<double>& y, const std::vector<double>& slope) noexcept {
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = y[i] + ahead_ * slope[i];
}

// The pieces that all arguments are in a little ahead.
void LoadBreaks::read_pieces(double t, const std::vector<double>& y, const std::vector<double>& slope,
                             MotionEquations& equations, Pieces& pieces) noexcept {
  HeldPieces& held = scratch_.loads.held;
  std::ranges::fill(held.pieces, kFreePiece);
  held.surface = -1;
  held.share = 0.0;
  move_ahead(y, slope);
  if (n_stalls_ > 0) {  // from rest only the slope there tells where it goes
    eval(t + ahead_, state_, later_slope_, equations);
    move_ahead(y, later_slope_);
  }
  measure(t + ahead_, state_.data(), equations);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const BreakState& state = scratch_.loads.breaks[k];
    pieces[k] = state.met ? state.piece : kFreePiece;
  }
}

// Each choice of pieces moves the motion somewhere: a choice is right when it moves into the pieces it is made of.
bool LoadBreaks::choose_pieces(double t, const std::vector<double>& y, std::vector<double>& slope,
                               MotionEquations& equations) {
  HeldPieces& held = equations.workspace.loads.held;
  read_pieces(t, y, slope, equations, tried_[0]);
  for (int k = 0; k < kMostTries; ++k) {
    held.pieces = held.others = tried_[k];
    held.surface = -1;
    held.share = 0.0;
    eval(t, y, slope, equations);
    read_pieces(t, y, slope, equations, next_);
    if (next_ == tried_[k]) return true;
    if (k > 0 && next_ == tried_[k - 1]) return begin_slide(t, y, slope, equations, tried_[k - 1], tried_[k]);
    tried_[k + 1] = next_;
  }
  stalled_ = static_cast<std::size_t>(std::ranges::mismatch(tried_[kMostTries], tried_[kMostTries - 1]).in1 -
                                      tried_[kMostTries].begin());
  return false;
}

// Both choices move the motion into the other: it stays between.
bool LoadBreaks::begin_slide(double t, const std::vector<double>& y, std::vector<double>& slope,
                             MotionEquations& equations, const Pieces& one, const Pieces& other) {
  HeldPieces& held = equations.workspace.loads.held;
  held.pieces = one;
  held.others = other;
  const auto first = std::ranges::mismatch(one, other).in1;
  stalled_ = static_cast<std::size_t>(first - one.begin());
  held.surface = static_cast<int>(stalled_);
  if (one[stalled_] == kFreePiece || other[stalled_] == kFreePiece) return false;
  // What changes together must stay together: how far each argument gets ahead on one side, and between both.
  const auto find_way = [&](std::size_t k) {
    scratch_.loads.held = equations.workspace.loads.held;
    scratch_.loads.held.surface = -1;
    measure(t, y.data(), equations);
    const double here = scratch_.loads.breaks[k].argument;
    move_ahead(y, slope);
    measure(t + ahead_, state_.data(), equations);
    return std::abs(scratch_.loads.breaks[k].argument - here);
  };
  for (std::size_t k = stalled_; k < one.size(); ++k) {
    if (one[k] == other[k]) continue;
    held.surface = -1;
    held.share = 0.0;
    eval(t, y, slope, equations);
    const double alone = find_way(k);
    held.surface = static_cast<int>(stalled_);
    eval(t, y, slope, equations);
    if (!(find_way(k) <= kStaysOn * alone)) return false;
  }
  const double share = held.share;
  return share >= 0.0 && share <= 1.0;
}

// What a motion that slides does at this state: true when it goes on in one piece or between the same two.
bool LoadBreaks::leave_slide(double t, const std::vector<double>& y, std::vector<double>& slope,
                             MotionEquations& equations) {
  HeldPieces& held = equations.workspace.loads.held;
  read_pieces(t, y, slope, equations, next_);
  bool others_change = false;
  for (std::size_t k = 0; k < next_.size(); ++k) {
    if (held.pieces[k] != held.others[k] || next_[k] == held.pieces[k]) continue;
    held.pieces[k] = held.others[k] = next_[k];
    others_change = true;
  }
  eval(t, y, slope, equations);
  const double share = held.share;
  if (share > 0.0 && share < 1.0) return true;
  (share > 0.5 ? held.pieces : held.others) = share > 0.5 ? held.others : held.pieces;
  held.surface = -1;
  held.share = 0.0;
  eval(t, y, slope, equations);
  return !others_change;
}

// Between which values each argument may go on.
void LoadBreaks::bound_pieces(double t, const std::vector<double>& y, const std::vector<double>& slope,
                              MotionEquations& equations) noexcept {
  const HeldPieces& held = equations.workspace.loads.held;
  HeldPieces& looked = scratch_.loads.held;
  looked = held;
  looked.surface = -1;
  looked.share = 0.0;
  std::ranges::fill(motion_pieces_, kFreePiece);
  move_ahead(y, slope);
  measure(t + ahead_, state_.data(), equations);
  looked = held;
  is_searched_ = false;
  for (std::size_t k = 0; k < watched_.size(); ++k) {
    Watched& watched = watched_[k];
    watched.low = -kInfinity;
    watched.high = kInfinity;
    if (watched.kind == Kind::formula) {
      const BreakState& state = scratch_.loads.breaks[watched.index];
      const bool slides = held.surface >= 0 && held.pieces[watched.index] != held.others[watched.index];
      if (state.met && !slides) watched.low = state.low, watched.high = state.high;
    } else if (watched.kind == Kind::motion) {
      const BreakState& state = motion_states_[watched.index];
      motion_pieces_[watched.index] = state.met ? state.piece : kFreePiece;
      if (state.met) watched.low = state.low, watched.high = state.high;
    } else if (watched.kind == Kind::curve) {
      std::tie(watched.low, watched.high) = curves_[watched.index].curve->find_piece(arguments_[k]);
    } else if (held.surface >= 0) {
      watched.low = 0.0, watched.high = 1.0;
    }
    is_searched_ = is_searched_ || std::isfinite(watched.low) || std::isfinite(watched.high);
  }
}

// All arguments at a state.
void LoadBreaks::measure(double t, const double* y, MotionEquations& equations) noexcept {
  if (scratch_.loads.held.surface >= 0) {
    equations.eval_in(t, y, scratch_);
  } else {
    update_coordinates(system_->tables, t, y, y + equations.n_free(), scratch_.coordinates);
    update_point_motions(system_->tables, scratch_);
    update_breaks(system_->tables, t, scratch_);
  }
  for (WatchedMotion& motion : motions_) {
    (void)motion.evaluator.eval(&t, motion_pieces_.data() + motion.first_break,
                                motion_states_.data() + motion.first_break);
  }
  for (std::size_t k = 0; k < watched_.size(); ++k) {
    const Watched& watched = watched_[k];
    switch (watched.kind) {
      case Kind::formula:
      case Kind::motion: {
        const BreakState& state =
            watched.kind == Kind::formula ? scratch_.loads.breaks[watched.index] : motion_states_[watched.index];
        arguments_[k] = state.met ? state.argument : std::numeric_limits<double>::quiet_NaN();
        break;
      }
      case Kind::curve:
        arguments_[k] = scratch_.loads.channel_values[static_cast<std::size_t>(curves_[watched.index].channel)];
        break;
      case Kind::share:
        arguments_[k] = scratch_.loads.held.share;
        break;
    }
  }
}

LoadBreaks::Stall LoadBreaks::find_stall() const {
  const LoadTables& loads = system_->tables.loads;
  const auto holds = [&](const LoadFunction& function) {
    if (function.expression < 0) return false;
    const auto e = static_cast<std::size_t>(function.expression);
    const std::size_t first = scratch_.loads.first_break[e];
    return stalled_ >= first && stalled_ < first + scratch_.loads.evaluators[e].breaks().size();
  };
  const auto describe = [&](int load, const LoadFunction& function) {
    const auto e = static_cast<std::size_t>(function.expression);
    return Stall{load, scratch_.loads.evaluators[e].breaks()[stalled_ - scratch_.loads.first_break[e]].text};
  };
  for (const ForceLoad& force : loads.forces) {
    if (holds(force.x)) return describe(force.load, force.x);
    if (holds(force.y)) return describe(force.load, force.y);
  }
  for (const TorqueLoad& torque : loads.torques) {
    if (holds(torque.torque)) return describe(torque.load, torque.torque);
  }
  return {};
}

}  // namespace gudgeon
