// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is watched, how long pieces are held, and what is told where none can be.
#include "gudgeon/sim/load_breaks.h"

#include <fmt/format.h>

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
// A located step ends within the window past a break; this many windows ahead the motion is in the next piece. Where
// that turns out wrong, as where an argument creeps, it looks ten times farther each time.
constexpr double kWindowsAhead = 4.0;
constexpr double kFarther = 10.0;
constexpr int kMostStalls = 6;
// Where many changes in a row fall within this share of a cycle, or some that take so many evaluations, as about a
// speed that comes to rest under a force that vanishes with it, nothing is held for a while, and the step control sees
// what there is to see; for longer each time that follows on the last.
constexpr double kCrowdShare = 1e-6;
constexpr std::int64_t kCrowdEvaluations = 1000;
constexpr double kFirstReleaseShare = 1e-3;
constexpr double kLongestReleaseShare = 0.1;

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
  for (std::size_t f = 0; f < scratch_.loads.evaluators.size(); ++f) {
    formula_of_.insert(formula_of_.end(), scratch_.loads.evaluators[f].breaks().size(), f);
  }
  turned_.reserve(formula_of_.size());
  turned_formulas_.reserve(scratch_.loads.evaluators.size());
  turned_rates_.assign((scratch_.loads.evaluators.size() + 1) * formula_of_.size(), 0.0);
  reach_.assign(formula_of_.size(), kInfinity);
  is_restless_.assign(formula_of_.size(), 0);
  is_decided_ = is_restless_;
  later_slope_ = state_;
  recent_.fill({-kInfinity, 0});
  released_until_ = -kInfinity;
  last_ = scratch_.loads.held;
}

void LoadBreaks::transfer(StateArchive& archive) {
  scratch_.fit(system_->tables);
  archive(watched_, motion_states_, motion_pieces_, scratch_, is_searched_, arguments_, excess_, state_, later_slope_);
  archive(tried_, next_, last_, reach_, is_restless_, is_decided_, last_left_, has_changed_);
  archive(ahead_, held_at_, n_stalls_, n_changes_, recent_, release_, released_until_);
  archive.list(turned_);
  archive.list(turned_formulas_);
  archive(turned_rates_);
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
  const std::size_t n_formulas = watched_.empty() ? 0 : scratch_.loads.evaluators.size();
  for (std::size_t k = 0; k < std::min<std::size_t>(n_formulas, MotionEquations::kMostSlides); ++k) {
    watched_.push_back({Kind::share, k, -kInfinity, kInfinity});
  }
  const auto watch = [&](const LoadFunction& function, int load) {
    if (function.curve < 0) return;
    const Curve& curve = loads.curves[static_cast<std::size_t>(function.curve)];
    if (loads.channels[static_cast<std::size_t>(function.channel)].quantity == StateChannel::Quantity::time) {
      clocks_.push_back(curve);
      return;
    }
    watched_.push_back({Kind::curve, curves_.size(), -kInfinity, kInfinity});
    curves_.push_back({&curve, function.channel, load});
  };
  for (const ForceLoad& force : loads.forces) watch(force.x, force.load), watch(force.y, force.load);
  for (const TorqueLoad& torque : loads.torques) watch(torque.torque, torque.load);
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
      motions_.push_back({std::move(evaluator), first, driven.driver});
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
  if (n_stalls_ == 0) std::ranges::fill(is_restless_, 0);
  if (n_stalls_ > kMostStalls) return false;
  if (is_crowded(t)) {
    release(t, y, slope, equations);
    return true;
  }
  if (!scratch_.loads.breaks.empty()) {
    const HeldPieces& held = equations.workspace.loads.held;
    last_ = held;
    const bool is_found = choose_pieces(t, y, slope, equations);
    for (std::size_t k = 0; k < is_restless_.size(); ++k) {
      if (held.pieces[k] != last_.pieces[k] || held.others[k] != last_.others[k]) is_restless_[k] = 1;
    }
    if (!is_found) return false;
    eval(t, y, slope, equations);
    has_changed_ = held.n_slides != last_.n_slides || held.pieces != last_.pieces || held.others != last_.others;
  }
  bound_pieces(t, y, slope, equations);
  return true;
}

// Whether changes follow each other closely; notes this one.
bool LoadBreaks::is_crowded(double t) noexcept {
  const double since = t - kCrowdShare * cycle_time_;
  Change& oldest = recent_[static_cast<std::size_t>(n_changes_) % recent_.size()];
  bool crowded = oldest.time > since;
  for (const Change& change : recent_) {
    crowded = crowded || (change.time > since && statistics_->evaluations - change.evaluations > kCrowdEvaluations);
  }
  oldest = {t, statistics_->evaluations};
  return crowded;
}

// Holds nothing for a while.
void LoadBreaks::release(double t, const std::vector<double>& y, std::vector<double>& slope,
                         MotionEquations& equations) noexcept {
  const bool follows = t - released_until_ < release_;
  release_ = follows ? std::min(2.0 * release_, kLongestReleaseShare * cycle_time_) : kFirstReleaseShare * cycle_time_;
  released_until_ = t + release_;
  recent_.fill({-kInfinity, 0});
  HeldPieces& held = equations.workspace.loads.held;
  std::ranges::fill(held.pieces, kFreePiece);
  std::ranges::fill(held.others, kFreePiece);
  held.stop_slides();
  std::ranges::fill(reach_, kInfinity);
  for (Watched& watched : watched_) watched.low = -kInfinity, watched.high = kInfinity;
  is_searched_ = false;
  has_changed_ = true;
  eval(t, y, slope, equations);
}

// Between which values each argument may go on.
void LoadBreaks::bound_pieces(double t, const std::vector<double>& y, const std::vector<double>& slope,
                              MotionEquations& equations) noexcept {
  const HeldPieces& held = equations.workspace.loads.held;
  HeldPieces& looked = scratch_.loads.held;
  looked = held;
  looked.stop_slides();
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
      const bool slides = held.pieces[watched.index] != held.others[watched.index];
      if (slides) watched.low = -reach_[watched.index], watched.high = reach_[watched.index];
      if (state.met && !slides) watched.low = state.low, watched.high = state.high;
    } else if (watched.kind == Kind::motion) {
      const BreakState& state = motion_states_[watched.index];
      motion_pieces_[watched.index] = state.met ? state.piece : kFreePiece;
      if (state.met) watched.low = state.low, watched.high = state.high;
    } else if (watched.kind == Kind::curve) {
      std::tie(watched.low, watched.high) = curves_[watched.index].curve->find_piece(arguments_[k]);
    } else if (static_cast<int>(watched.index) < held.n_slides) {
      watched.low = 0.0, watched.high = 1.0;
    }
    is_searched_ = is_searched_ || std::isfinite(watched.low) || std::isfinite(watched.high);
  }
}

// All arguments at a state.
void LoadBreaks::measure(double t, const double* y, MotionEquations& equations) noexcept {
  if (scratch_.loads.held.n_slides > 0) {
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
        arguments_[k] = scratch_.loads.held.find_share(static_cast<int>(watched.index));
        break;
    }
  }
}

LoadBreaks::Stall LoadBreaks::find_stall() const {
  Stall stall;
  for (std::size_t k = 0; k < is_restless_.size(); ++k) {
    if (is_restless_[k] != 0) stall.places.push_back(describe(k));
  }
  if (!stall.places.empty()) return stall;
  const Watched& watched = watched_[last_left_];
  const Mechanism& mechanism = system_->mechanism;
  if (watched.kind == Kind::formula) {
    stall.places.push_back(describe(watched.index));
  } else if (watched.kind == Kind::curve) {
    const WatchedCurve& curve = curves_[watched.index];
    stall.places.push_back(
        {fmt::format("load '{}'", mechanism.loads[static_cast<std::size_t>(curve.load)].name),
         "a point of its curve over " + system_->tables.loads.channel_names[static_cast<std::size_t>(curve.channel)]});
  } else if (watched.kind == Kind::motion) {
    const auto behind =
        std::ranges::find_if(motions_, [&](const WatchedMotion& motion) { return motion.first_break > watched.index; });
    const WatchedMotion& motion = *std::prev(behind);
    stall.places.push_back({fmt::format("driver '{}'", mechanism.drivers[static_cast<std::size_t>(motion.driver)].name),
                            motion.evaluator.breaks()[watched.index - motion.first_break].text});
  }
  return stall;
}

// A break of a load's formula, and whose it is.
LoadBreaks::Stall::Place LoadBreaks::describe(std::size_t at) const {
  const LoadTables& loads = system_->tables.loads;
  const std::size_t formula = formula_of_[at];
  const auto holds = [&](const LoadFunction& function) { return function.expression == static_cast<int>(formula); };
  int load = -1;
  for (const ForceLoad& force : loads.forces) {
    if (holds(force.x) || holds(force.y)) load = force.load;
  }
  for (const TorqueLoad& torque : loads.torques) {
    if (holds(torque.torque)) load = torque.load;
  }
  return {fmt::format("load '{}'", system_->mechanism.loads[static_cast<std::size_t>(load)].name),
          scratch_.loads.evaluators[formula].breaks()[at - scratch_.loads.first_break[formula]].text};
}

}  // namespace gudgeon
