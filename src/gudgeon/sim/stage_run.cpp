// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Steps, contact changes, projection, sampling.
#include "gudgeon/sim/stage_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

namespace gudgeon {

namespace {

// Onset is located this well [s]; the integrator stops within it, before the surfaces touch.
constexpr double kOnsetTime = 1e-10;
// A step below this [s] means that the run cannot go on.
constexpr double kSmallestStep = 1e-12;
// Landing on a change takes one or two passes; bisection from the longest step to the shortest would take this many.
constexpr int kMostLandings = 50;
// Closure errors above this share of the absolute tolerance are projected away.
constexpr double kProjectionShare = 0.1;
// A step is at most this share of a cycle, so that no motion of the mechanism is jumped over.
constexpr double kLargestStepShare = 0.02;
// The first step is this share of a cycle; the error control finds the right one within a few.
constexpr double kFirstStepShare = 1e-5;

}  // namespace

StageRun::StageRun(const System& system, const Study& study, double cycle_time, std::string name)
    : system_(system),
      study_(study),
      equations_(system, study.stabilization == Stabilization::baumgarte
                             ? Feedback{study.baumgarte_alpha, study.baumgarte_beta}
                             : Feedback{}),
      stepper_(equations_.size()),
      control_(study, static_cast<std::size_t>(system.tables.counts.n_free_turns), 2 * equations_.n_free(),
               kFirstStepShare * cycle_time),
      projection_(system.tables, kProjectionShare * study.absolute_tolerance),
      passage_(study.absolute_tolerance + study.relative_tolerance),
      events_(system.tables),
      recorder_(system),
      scratch_(system.tables),
      warm_up_end_(study.warm_up_cycles * cycle_time),
      end_((study.warm_up_cycles + study.cycles) * cycle_time),
      sample_step_(cycle_time / study.outputs_per_cycle),
      y_(equations_.size(), 0.0),
      slope_(equations_.size(), 0.0),
      interpolated_(equations_.size()),
      gaps_(system.tables.contacts.size()),
      end_gaps_(system.tables.contacts.size()),
      samples_(DormandPrince::kStages, std::vector<ContactSample>(system.tables.contacts.size())),
      history_(system.tables.contacts.size(), study.warm_up_cycles * cycle_time) {
  record_.name = std::move(name);
  record_.cycle_time = cycle_time;
  record_.start_time = warm_up_end_;
  for (const Contact& contact : system.tables.contacts) wear_.emplace_back(contact, study.deposition, study.regions);
}

StageRecord StageRun::run(const State& start, const std::stop_token& stop,
                          const std::function<void(double)>& progress) {
  const auto clock_start = std::chrono::steady_clock::now();
  begin(start);
  int reported = 0;
  while (time_ < end_ && record_.status == StageStatus::finished) {
    if (stop.stop_requested()) {
      record_.status = StageStatus::stopped;
      record_.message = fmt::format("stopped on request at t = {:.6f} s", time_);
      break;
    }
    if (!advance()) break;
    if (const int percent = static_cast<int>(100.0 * time_ / end_); percent > reported) {
      reported = percent;
      if (progress) progress(time_ / end_);
    }
  }
  finish();
  record_.solver.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock_start).count();
  return std::move(record_);
}

void StageRun::begin(const State& start) {
  std::ranges::copy(start.q, y_.begin());
  std::ranges::copy(start.v, y_.begin() + static_cast<std::ptrdiff_t>(equations_.n_free()));
  equations_.eval(0.0, y_.data(), slope_.data());
  ++record_.solver.evaluations;
  project();
  if (!std::ranges::all_of(slope_, [](double s) { return std::isfinite(s); })) {
    fail("the start position is singular: accelerations are not determined");
    return;
  }
  initial_energies_ = recorder_.find_energies(equations_.workspace);
  events_.find_gaps(equations_.workspace, end_gaps_);
  for (std::size_t k = 0; k < end_gaps_.size(); ++k) {
    if (!(end_gaps_[k].penetration > 0.0)) continue;
    fail(fmt::format("joint '{}' starts with its journal {:.4g} um inside its bearing",
                     system_.mechanism.joints[system_.tables.contacts[k].joint].name, 1e6 * end_gaps_[k].penetration));
  }
  gaps_ = end_gaps_;
  stepper_.begin(0.0, y_, slope_);
  if (warm_up_end_ == 0.0) sample_until(0.0, [&](double) { interpolated_ = y_; });
}

double StageRun::next_milestone() const { return time_ < warm_up_end_ ? warm_up_end_ : end_; }

// One accepted step, or failure.
bool StageRun::advance() {
  if (pass_singular_position()) return true;
  double h = std::min(control_.next_step(), kLargestStepShare * record_.cycle_time);
  h = std::min(h, passage_.find_longest_step());
  if (study_.max_step > 0.0) h = std::min(h, study_.max_step);
  const double left = next_milestone() - time_;
  if (h >= left * (1.0 - 1e-12)) h = left;  // no sliver of a step before a milestone
  while (!attempt_step(h)) {
    ++record_.solver.rejected_steps;
    h = std::min(h, control_.next_step());
    if (h < kSmallestStep) {
      fail("step below 1e-12 s");
      return false;
    }
  }
  accept();
  return true;
}

// Strides over a singular position that lies ahead; only free motion is smooth enough to be continued.
bool StageRun::pass_singular_position() {
  const std::optional<double> far_side = passage_.find_far_side();
  if (!far_side || *far_side >= next_milestone()) return false;
  if (std::ranges::any_of(equations_.latches, &ContactLatch::in_contact)) return false;
  sample_until(*far_side, [&](double at) { passage_.interpolate(at, interpolated_); });
  passage_.interpolate(*far_side, y_);
  time_ = *far_side;
  passage_.forget();
  equations_.eval(time_, y_.data(), slope_.data());
  ++record_.solver.evaluations;
  project();
  events_.find_gaps(equations_.workspace, gaps_);
  stepper_.begin(time_, y_, slope_);
  return true;
}

// Tries h and, when a contact changes within it, the part up to the change.
bool StageRun::attempt_step(double h) {
  attempt(h);
  if (!control_.accepts(stepper_)) return false;
  events_.find_gaps(equations_.workspace, end_gaps_);
  const auto change = events_.find_first_change(stepper_, equations_.latches, gaps_, end_gaps_, scratch_);
  if (change) land_on_change(*change);
  return true;
}

void StageRun::attempt(double h) {
  stepper_.attempt(h, [&](int stage, double t, const double* y, double* slope) {
    equations_.eval(t, y, slope);
    for (std::size_t k = 0; k < gaps_.size(); ++k) {
      if (equations_.latches[k].in_contact) samples_[stage][k] = equations_.find_sample(k);
    }
  });
  record_.solver.evaluations += DormandPrince::kStages - 1;
}

// Steps again so as to end just on the near side of an onset, or just past a separation: within kOnsetTime of the change
// and with the gap open in both cases. Newton's method on the step's length, kept inside a bracket.
void StageRun::land_on_change(const ContactChange& change) {
  const std::size_t k = change.contact;
  const double sign = equations_.latches[k].in_contact ? -1.0 : 1.0;
  double before = 0.0;
  double after = stepper_.step();
  double h = std::clamp(change.share, 0.0, 1.0) * after;
  for (int pass = 0; pass < kMostLandings; ++pass) {
    attempt(h);
    events_.find_gaps(equations_.workspace, end_gaps_);
    const double penetration = end_gaps_[k].penetration;
    const double rate = end_gaps_[k].penetration_rate;
    if (!std::isfinite(penetration)) {
      after = h;
      h = 0.5 * (before + after);
      continue;
    }
    const double excess = penetration + 0.5 * kOnsetTime * std::abs(rate);
    if (std::abs(excess) <= 0.5 * kOnsetTime * std::abs(rate) || after - before <= kSmallestStep) break;
    (sign * excess > 0.0 ? after : before) = h;
    const double newton = h - excess / rate;
    h = newton > before && newton < after ? newton : 0.5 * (before + after);
  }
  pending_change_ = k;
}

void StageRun::change_contact(std::size_t k) {
  ContactLatch& latch = equations_.latches[k];
  passage_.forget();
  if (latch.in_contact) {
    latch = {};
    for (auto& stage : samples_) stage[k] = {};
    history_.end(k, time_);
    ++record_.solver.separations;
    return;
  }
  latch = {true, end_gaps_[k].penetration_rate};
  const RevoluteMotion motion = find_contact_motion(system_.tables.contacts[k], equations_.workspace);
  const double direction = std::atan2(motion.offset.y, motion.offset.x) - motion.bearing_angle;
  history_.begin(k, time_, latch.onset_speed, std::remainder(direction, 2.0 * std::numbers::pi));
  control_.note_onset();
  ++record_.solver.onsets;
}

void StageRun::accept() {
  SolverStatistics& solver = record_.solver;
  const double h = stepper_.step();
  const double end_time = stepper_.start_time() + h;
  // The milestones are hit exactly, not to rounding.
  const double milestone = next_milestone();
  const double new_time = std::abs(end_time - milestone) <= 1e-12 * milestone ? milestone : end_time;
  ++solver.accepted_steps;
  // Two contacts may change at one instant, with no time between.
  if (h > 0.0) solver.smallest_step = solver.smallest_step > 0.0 ? std::min(solver.smallest_step, h) : h;
  solver.largest_step = std::max(solver.largest_step, h);
  control_.note_step(h);

  if (time_ >= warm_up_end_) deposit_wear();
  time_ = new_time;
  y_ = stepper_.end();
  slope_ = stepper_.end_slope();
  if (h > 0.0) sample_until(time_, [&](double at) { interpolate_step(at); });
  project();
  watch_contacts();
  passage_.note(time_, y_, slope_, find_singular_closeness(system_.tables, equations_.workspace));
  if (pending_change_) change_contact(*std::exchange(pending_change_, std::nullopt));
  gaps_ = end_gaps_;
  stepper_.begin(time_, y_, slope_);
}

void StageRun::deposit_wear() {
  const double h = stepper_.step();
  for (std::size_t k = 0; k < wear_.size(); ++k) {
    // Stages that saw no contact hold a sample without force.
    bool touched = false;
    for (int stage = 0; stage < DormandPrince::kStages; ++stage) {
      const double weight = DormandPrince::kWeights[stage] * h;
      if (weight == 0.0 || samples_[stage][k].normal_force == 0.0) continue;
      wear_[k].add(samples_[stage][k], weight);
      touched = true;
    }
    if (touched) wear_[k].add_contact_time(h);
  }
}

void StageRun::project() {
  SolverStatistics& solver = record_.solver;
  solver.closure_residual = std::max(solver.closure_residual, find_largest(equations_.workspace.closure_gap));
  if (study_.stabilization == Stabilization::baumgarte) return;
  const int n_corrections = projection_.project(time_, y_, slope_, equations_);
  solver.projections += n_corrections;
  solver.evaluations += n_corrections;
}

void StageRun::watch_contacts() {
  Workspace& workspace = equations_.workspace;
  if (time_ == warm_up_end_) recorder_.reset_statistics();
  if (time_ >= warm_up_end_) recorder_.watch(time_, workspace, end_gaps_);
  for (std::size_t k = 0; k < end_gaps_.size(); ++k) {
    if (!equations_.latches[k].in_contact) continue;
    samples_[0][k] = equations_.find_sample(k);
    history_.watch(k, samples_[0][k].normal_force);
  }
}

// All samples up to a time; interpolate(t) writes the state at t to interpolated_.
template <class Interpolate>
void StageRun::sample_until(double time, Interpolate&& interpolate) {
  const std::int64_t n_total = static_cast<std::int64_t>(study_.cycles) * study_.outputs_per_cycle;
  for (; n_samples_ <= n_total; ++n_samples_) {
    const double at = warm_up_end_ + static_cast<double>(n_samples_) * sample_step_;
    // The last sample stands at the end, whatever rounding says.
    if (at > time && !(n_samples_ == n_total && time >= end_)) return;
    interpolate(at);
    const double* y = interpolated_.data();
    eval_dynamics(system_.tables, at, y, y + equations_.n_free(), equations_.latches, equations_.feedback(), scratch_);
    recorder_.sample(at, scratch_, equations_.latches, initial_energies_.total(), y + 2 * equations_.n_free());
  }
}

void StageRun::interpolate_step(double time) {
  const double share = (time - stepper_.start_time()) / stepper_.step();
  stepper_.interpolate(std::clamp(share, 0.0, 1.0), interpolated_.size(), interpolated_.data());
}

void StageRun::fail(const std::string& reason) {
  record_.status = StageStatus::failed;
  record_.message = fmt::format("E-NUM-003: stopped at t = {:.9f} s (cycle {}): {}", time_,
                                static_cast<int>(time_ / record_.cycle_time) + 1, reason);
  double deepest = 0.0;
  std::size_t stiffest = gaps_.size();
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    if (equations_.latches[k].in_contact && gaps_[k].penetration > deepest) deepest = gaps_[k].penetration, stiffest = k;
  }
  if (stiffest < gaps_.size()) {
    record_.message += fmt::format("; stiffest contact: joint '{}', penetration {:.3g} um, normal force {:.3g} N",
                                   system_.mechanism.joints[system_.tables.contacts[stiffest].joint].name,
                                   1e6 * deepest, samples_[0][stiffest].normal_force);
  }
}

void StageRun::finish() {
  record_.end_time = time_;
  record_.cycles = static_cast<int>(std::max(0.0, time_ - warm_up_end_) / record_.cycle_time + 1e-9);
  for (std::size_t k = 0; k < end_gaps_.size(); ++k) {
    if (equations_.latches[k].in_contact) history_.end(k, time_);
  }
  record_.events = std::move(history_.events());
  for (std::size_t k = 0; k < wear_.size(); ++k) {
    record_.wear.push_back(wear_[k].summarize(system_.mechanism.joints[system_.tables.contacts[k].joint].name,
                                              study_.magnification));
  }
  // A failed attempt may have left anything in the workspace: evaluate the last accepted state again.
  equations_.eval(time_, y_.data(), slope_.data());
  const StageRecorder::Energies energies = recorder_.find_energies(equations_.workspace);
  const double* integrals = y_.data() + 2 * equations_.n_free();
  EnergyLedger& ledger = record_.ledger;
  ledger.initial_energy = initial_energies_.total();
  ledger.kinetic = energies.kinetic;
  ledger.potential = energies.potential;
  ledger.elastic = energies.elastic;
  ledger.driver_work = integrals[kDriverWork];
  ledger.contact_damping = integrals[kContactDamping];
  ledger.friction = integrals[kFrictionLoss];
  ledger.surface_work = integrals[kSurfaceWork];
  ledger.exchanged = integrals[kExchanged];
  recorder_.finish(record_);
}

}  // namespace gudgeon
