// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Step control, contact changes, projection, sampling.
#include "gudgeon/sim/stage_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

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
// Step control: safety, bounds of one change, and the exponents of a proportional-integral controller of order 5.
constexpr double kSafety = 0.9;
constexpr double kLeastChange = 0.2;
constexpr double kMostChange = 5.0;
constexpr double kLeastError = 1e-10;
constexpr double kErrorExponent = 0.17;
constexpr double kLastErrorExponent = 0.04;

}  // namespace

StageRun::StageRun(const System& system, const Study& study, double cycle_time, std::string name)
    : system_(system),
      study_(study),
      equations_(system, study.stabilization == Stabilization::baumgarte
                             ? Feedback{study.baumgarte_alpha, study.baumgarte_beta}
                             : Feedback{}),
      stepper_(equations_.size()),
      events_(system.tables),
      recorder_(system),
      scratch_(system.tables),
      warm_up_end_(study.warm_up_cycles * cycle_time),
      end_((study.warm_up_cycles + study.cycles) * cycle_time),
      sample_step_(cycle_time / study.outputs_per_cycle),
      y_(equations_.size(), 0.0),
      slope_(equations_.size(), 0.0),
      interpolated_(equations_.size()),
      correction_(equations_.n_free()),
      residual_(system.tables.closures.size()),
      gaps_(system.tables.contacts.size()),
      end_gaps_(system.tables.contacts.size()),
      samples_(DormandPrince::kStages, std::vector<ContactSample>(system.tables.contacts.size())),
      open_events_(system.tables.contacts.size()) {
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
    if (end_gaps_[k].penetration > 0.0) change_contact(k);
  }
  gaps_ = end_gaps_;
  stepper_.begin(0.0, y_, slope_);
  // A small fraction of a cycle; the error control finds the right step within a few.
  h_next_ = 1e-5 * record_.cycle_time;
  if (warm_up_end_ == 0.0) sample_until(0.0);
}

double StageRun::next_milestone() const { return time_ < warm_up_end_ ? warm_up_end_ : end_; }

// One accepted step, or failure.
bool StageRun::advance() {
  double h = std::min(h_next_, kLargestStepShare * record_.cycle_time);
  if (study_.max_step > 0.0) h = std::min(h, study_.max_step);
  const double left = next_milestone() - time_;
  const bool last = h >= left * (1.0 - 1e-12);
  if (last) h = left;
  while (!attempt_step(h)) {
    ++record_.solver.rejected_steps;
    h = std::min(h_next_, 0.9 * h);
    if (h < kSmallestStep) {
      fail("step below 1e-12 s");
      return false;
    }
  }
  accept();
  return true;
}

// Tries h and, when a contact changes within it, the part up to the change. Sets h_next_.
bool StageRun::attempt_step(double h) {
  attempt(h);
  const double error = find_error();
  if (!std::isfinite(error)) {
    h_next_ = kLeastChange * h;
    return false;
  }
  const double change = kSafety * std::pow(error, -kErrorExponent) * std::pow(last_error_, kLastErrorExponent);
  h_next_ = h * std::clamp(change, kLeastChange, error > 1.0 ? 1.0 : kMostChange);
  if (error > 1.0) return false;
  last_error_ = std::max(error, 1e-4);

  events_.find_gaps(equations_.workspace, end_gaps_);
  const auto contact_change =
      events_.find_first_change(stepper_, equations_.latches, gaps_, end_gaps_, scratch_);
  return !contact_change || land_on_change(*contact_change);
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

// Root mean square of the local errors of coordinates and rates, against their tolerances; energies follow from them.
double StageRun::find_error() const {
  const std::size_t n_free = equations_.n_free();
  const auto n_turns = static_cast<std::size_t>(system_.tables.counts.n_free_turns);
  double sum = 0.0;
  for (std::size_t i = 0; i < 2 * n_free; ++i) {
    double size = std::max(std::abs(stepper_.start()[i]), std::abs(stepper_.end()[i]));
    if (i < n_turns) size = std::min(size, 1.0);  // an angle's error does not become harmless after many turns
    const double ratio = stepper_.error()[i] / (study_.absolute_tolerance + study_.relative_tolerance * size);
    sum += ratio * ratio;
  }
  for (std::size_t i = 2 * n_free; i < stepper_.end().size(); ++i) sum += 0.0 * stepper_.end()[i];  // must be finite
  if (n_free == 0) return kLeastError;
  return std::max(std::sqrt(sum / static_cast<double>(2 * n_free)), kLeastError);
}

// Steps again so as to end just on the near side of an onset, or just past a separation: within kOnsetTime of the change
// and with the gap open in both cases. Newton's method on the step's length, kept inside a bracket.
bool StageRun::land_on_change(const ContactChange& change) {
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
    if (!std::isfinite(penetration)) return false;
    const double excess = penetration + 0.5 * kOnsetTime * std::abs(rate);
    if (std::abs(excess) <= 0.5 * kOnsetTime * std::abs(rate) || after - before <= kSmallestStep) break;
    (sign * excess > 0.0 ? after : before) = h;
    const double newton = h - excess / rate;
    h = newton > before && newton < after ? newton : 0.5 * (before + after);
  }
  pending_change_ = k;
  return true;
}

void StageRun::change_contact(std::size_t k) {
  ContactLatch& latch = equations_.latches[k];
  ContactEvent& event = open_events_[k];
  if (latch.in_contact) {
    latch = {};
    event.duration = time_ - event.onset_time;
    if (event.onset_time >= warm_up_end_) record_.events.push_back(event);
    ++record_.solver.separations;
    return;
  }
  latch = {true, end_gaps_[k].penetration_rate};
  const Contact& contact = system_.tables.contacts[k];
  const RevoluteMotion motion = find_contact_motion(contact, equations_.workspace);
  const double direction = std::atan2(motion.offset.y, motion.offset.x) - motion.bearing_angle;
  event = {static_cast<std::int32_t>(k), time_, 0.0, latch.onset_speed,
           std::remainder(direction, 2.0 * std::numbers::pi), 0.0};
  ++record_.solver.onsets;
  if (h_after_onset_ > 0.0) h_next_ = std::min(h_next_, h_after_onset_);
  after_onset_ = true;
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

  if (time_ >= warm_up_end_) deposit_wear();
  time_ = new_time;
  y_ = stepper_.end();
  slope_ = stepper_.end_slope();
  sample_until(time_);
  project();
  watch_contacts();
  if (pending_change_) change_contact(*pending_change_);
  pending_change_.reset();
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

// Projects positions, then rates, while the closures are off by more than tolerance.
void StageRun::project() {
  Workspace& workspace = equations_.workspace;
  const std::size_t n_free = equations_.n_free();
  const auto largest = [](const std::vector<Vec2>& residual) {
    double most = 0.0;
    for (const Vec2 r : residual) most = std::max(most, norm(r));
    return most;
  };
  record_.solver.closure_residual = std::max(record_.solver.closure_residual, largest(workspace.closure_gap));
  if (study_.stabilization == Stabilization::baumgarte) return;
  const double tolerance = kProjectionShare * study_.absolute_tolerance;
  for (const bool rates : {false, true}) {
    const std::vector<Vec2>& current = rates ? workspace.closure_rate : workspace.closure_gap;
    if (largest(current) <= tolerance) continue;
    residual_ = current;
    find_correction(system_.tables, residual_, workspace, correction_.data());
    for (std::size_t i = 0; i < n_free; ++i) y_[(rates ? n_free : 0) + i] += correction_[i];
    equations_.eval(time_, y_.data(), slope_.data());
    ++record_.solver.evaluations;
    ++record_.solver.projections;
  }
}

void StageRun::watch_contacts() {
  Workspace& workspace = equations_.workspace;
  if (time_ == warm_up_end_) recorder_.reset_statistics();
  if (time_ >= warm_up_end_) recorder_.watch(time_, workspace, end_gaps_);
  for (std::size_t k = 0; k < open_events_.size(); ++k) {
    if (equations_.latches[k].in_contact) {
      samples_[0][k] = equations_.find_sample(k);
      open_events_[k].peak_force = std::max(open_events_[k].peak_force, samples_[0][k].normal_force);
    } else {
      for (auto& stage : samples_) stage[k] = {};
    }
  }
  if (after_onset_) after_onset_ = false, h_after_onset_ = stepper_.step();
}

// All samples that fall into the step just accepted.
void StageRun::sample_until(double time) {
  const std::int64_t n_total = static_cast<std::int64_t>(study_.cycles) * study_.outputs_per_cycle;
  for (; n_samples_ <= n_total; ++n_samples_) {
    const double at = warm_up_end_ + static_cast<double>(n_samples_) * sample_step_;
    // The last sample stands at the end, whatever rounding says.
    if (at > time && !(n_samples_ == n_total && time >= end_)) return;
    const double h = stepper_.step();
    const double share = h > 0.0 ? std::clamp((at - stepper_.start_time()) / h, 0.0, 1.0) : 0.0;
    if (h > 0.0) {
      stepper_.interpolate(share, interpolated_.size(), interpolated_.data());
    } else {
      interpolated_ = y_;
    }
    const double* y = interpolated_.data();
    eval_dynamics(system_.tables, at, y, y + equations_.n_free(), equations_.latches, {}, scratch_);
    recorder_.sample(at, scratch_, equations_.latches, initial_energies_.total(), y + 2 * equations_.n_free());
  }
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
  for (std::size_t k = 0; k < open_events_.size(); ++k) {
    if (!equations_.latches[k].in_contact) continue;
    open_events_[k].duration = time_ - open_events_[k].onset_time;
    if (time_ > warm_up_end_) record_.events.push_back(open_events_[k]);
  }
  for (std::size_t k = 0; k < wear_.size(); ++k) {
    record_.wear.push_back(wear_[k].summarize(system_.mechanism.joints[system_.tables.contacts[k].joint].name,
                                              study_.magnification));
  }
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
