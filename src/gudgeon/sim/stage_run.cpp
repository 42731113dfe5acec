// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The time loop, and what it keeps.
#include "gudgeon/sim/stage_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gudgeon/sim/lost_load.h"
#include "gudgeon/system/resting_start.h"

namespace gudgeon {

namespace {

// [shares of the clearance] Where surfaces are given to touch, rounding of their places is no penetration.
constexpr double kTouchingAtStart = 1e-9;
// Pivots this much smaller than at the start stand for a position within a thousandth of a singular one.
constexpr double kNearlySingular = 1e6;

}  // namespace

StageRun::StageRun(const System& system, const Study& study, double cycle_time, std::string name)
    : study_(study),
      motion_(system, study, cycle_time),
      system_(motion_.system()),
      recorder_(motion_.system()),
      history_(system.tables.contacts.size(), study.warm_up_cycles * cycle_time),
      peaks_(system_, motion_.equations(), recorder_, history_),
      scratch_(system.tables),
      pace_(cycle_time),
      reach_(system.mechanism),
      warm_up_end_(study.warm_up_cycles * cycle_time),
      end_((study.warm_up_cycles + study.cycles) * cycle_time),
      sample_step_(cycle_time / study.outputs_per_cycle),
      n_all_samples_(static_cast<std::size_t>(study.cycles) * static_cast<std::size_t>(study.outputs_per_cycle) + 1),
      interpolated_(motion_.y().size()) {
  step_.reserve(motion_.stepper().weights().size());
  record_.name = std::move(name);
  record_.cycle_time = cycle_time;
  record_.start_time = warm_up_end_;
  const std::span<const Contact> contacts(system_.tables.contacts);
  for (const ContactGroup& group : system_.tables.contact_groups) {
    const auto first = static_cast<std::size_t>(group.first_contact);
    const auto n = static_cast<std::size_t>(group.end_contact) - first;
    wear_.emplace_back(contacts.subspan(first, n), study.wear_distribution, study.cells, study.wear_acceleration);
  }
}

void StageRun::stream(std::size_t block_size, const std::function<void(const SampleBlock&)>& take) {
  recorder_.stream(block_size, [this, take](SampleBlock block) {
    block.stage = record_.name;
    take(block);
  });
}

StageRecord StageRun::run(const State& start, const std::stop_token& stop,
                          const std::function<void(double)>& progress) {
  began_at_ = Clock::now();
  recorder_.reserve(n_all_samples_);
  if (is_resumed_) {
    is_sampled_ = sample_until(motion_.time(), stop);
    check_step();
  } else {
    begin(start);
  }
  int reported = static_cast<int>(100.0 * motion_.time() / end_);
  while (motion_.time() < end_ && record_.status == StageStatus::finished) {
    if (stop.stop_requested()) {
      stop_on_request();
      break;
    }
    if (checkpoint_wanted_ != nullptr && checkpoint_wanted_->load(std::memory_order_relaxed)) take_checkpoint();
    advance(stop);
    if (const int percent = static_cast<int>(100.0 * motion_.time() / end_); percent > reported) {
      reported = percent;
      const auto told = Clock::now();
      if (progress) progress(motion_.time() / end_);
      began_at_ += Clock::now() - told;  // whoever is told of progress may let another case go first
    }
  }
  finish();
  record_.solver.wall_time = find_wall_time();
  return std::move(record_);
}

double StageRun::find_wall_time() const {
  return earlier_wall_time_ + std::chrono::duration<double>(Clock::now() - began_at_).count();
}

// One step and all that is kept of it.
void StageRun::advance(const std::stop_token& stop) {
  const double step_start = motion_.time();
  if (!motion_.advance(step_start < warm_up_end_ ? warm_up_end_ : end_)) return fail_step();
  take_step(step_start, stop);
  check_step();
}

// Whether the stage can go on after a step. It changes nothing when it is done again.
void StageRun::check_step() {
  if (!is_sampled_) return stop_on_request();
  stop_outside_slots();
  stop_open();
  if (!pace_.note(motion_.time(), motion_.statistics().evaluations, motion_.statistics().accepted_steps)) {
    stop_without_end();
  }
}

void StageRun::stop_on_request() {
  take_checkpoint();
  record_.status = StageStatus::stopped;
  record_.message = fmt::format("stopped on request at t = {:.9g} s", motion_.time());
}

void StageRun::begin(const State& start) {
  if (!motion_.begin(start)) {
    if (motion_.stall()) return fail_step();
    if (fail_jammed()) return;
    const bool lost = find_load_in_the_way(0.0, motion_.find_smallest_step(), motion_.y(), motion_.equations()) >= 0;
    fail("E-NUM-001", lost ? "the accelerations at the start are not determined"
                           : "the start position is singular: accelerations are not determined");
    return;
  }
  std::string inside;
  for (std::size_t k = 0; k < motion_.gaps().size(); ++k) {
    const double penetration = motion_.gaps()[k].penetration;
    const Joint& joint = system_.mechanism.joints[system_.tables.contacts[k].joint];
    if (!(penetration > kTouchingAtStart * find_clearance(joint.kind))) continue;
    inside += fmt::format("{}joint '{}' starts with its journal {:.4g} um inside its bearing",
                          inside.empty() ? "" : "; ", joint.name, 1e6 * penetration);
  }
  if (!inside.empty() && !rests_on_contacts(system_, start)) fail("E-NUM-002", inside);
  if (record_.status == StageStatus::finished) close_touching();
  initial_energies_ = recorder_.find_energies(motion_.equations().workspace);
  if (warm_up_end_ > 0.0) return;
  sample_until(0.0, {});
  peaks_.begin(motion_);
}

// Contacts whose surfaces touch or overlap at the start, and do not part, are made from the first moment on.
void StageRun::close_touching() {
  MotionEquations& equations = motion_.equations();
  bool any = false;
  for (std::size_t k = 0; k < motion_.gaps().size(); ++k) {
    const GapState& gap = motion_.gaps()[k];
    if (!(gap.penetration > 0.0) || gap.penetration_rate < 0.0) continue;
    open_contact(k);
    equations.contact_modes[k] = {true, gap.penetration_rate};
    any = true;
  }
  if (!any) return;
  motion_.evaluate_again();
  equations.initial_energy = equations.find_energy();
}

void StageRun::take_step(double step_start, const std::stop_token& stop) {
  const double now = motion_.time();
  reach_.note(motion_.equations().workspace);
  if (step_start >= warm_up_end_) accumulate_wear();
  is_sampled_ = sample_until(now, stop);
  if (step_start >= warm_up_end_) {
    peaks_.take_step(motion_);
  } else if (now >= warm_up_end_) {
    peaks_.begin(motion_);
  }
  if (const auto contact = motion_.changing_contact()) note_contact_change(*contact);
}

void StageRun::accumulate_wear() {
  const double h = motion_.last_step();
  const Stepper& step = motion_.stepper();
  const std::span<const double> nodes = step.nodes();
  const std::span<const double> weights = step.weights();
  const std::span<const double> shares = step.shares();
  for (std::size_t g = 0; g < wear_.size(); ++g) {
    const ContactGroup& group = system_.tables.contact_groups[g];
    bool touched = false;
    for (auto k = static_cast<std::size_t>(group.first_contact); k < static_cast<std::size_t>(group.end_contact); ++k) {
      step_.clear();
      for (std::size_t stage = 0; stage < nodes.size(); ++stage) {
        const ContactSample& sample = step.find_sample(static_cast<int>(stage), k);
        if (sample.journal_radius == 0.0) continue;  // not yet touched
        step_.push_back({&sample, nodes[stage], weights[stage] * h, shares[stage]});
        touched = touched || sample.normal_force > 0.0;
      }
      wear_[g].add(step_);
    }
    if (touched) wear_[g].add_contact_time(h);
  }
}

void StageRun::note_contact_change(std::size_t k) {
  const MotionEquations& equations = motion_.equations();
  if (equations.contact_modes[k].in_contact) {
    history_.end(k, motion_.time());
  } else {
    open_contact(k);
  }
}

void StageRun::open_contact(std::size_t k) {
  const MotionEquations& equations = motion_.equations();
  const Contact& contact = system_.tables.contacts[k];
  const RelativeMotion at = find_contact_motion(contact, equations.workspace);
  const ContactGap gap = find_gap(contact.surfaces, at);
  const double direction = std::atan2(gap.normal.y, gap.normal.x) - at.bearing_angle;
  ContactEvent opening;
  opening.joint = contact.group;
  opening.contact = static_cast<int>(k) - system_.tables.contact_groups[contact.group].first_contact;
  opening.onset_time = motion_.time();
  opening.onset_speed = motion_.gaps()[k].penetration_rate;
  opening.angle = std::remainder(direction, 2.0 * std::numbers::pi);
  opening.position = gap.bearing_position;
  history_.begin(k, opening);
}

// Past the end of its slot a journal has nothing to touch: what follows would be another mechanism.
void StageRun::stop_outside_slots() {
  for (std::size_t k = 0; k < motion_.gaps().size(); ++k) {
    if (!(motion_.gaps()[k].overrun > 0.0)) continue;
    const Contact& contact = system_.tables.contacts[k];
    stop("E-NUM-005", fmt::format("joint '{}': its journal left its bearing, {:.4g} mm "
                                  "past the end of the slot; make its bearing_length longer, or its motion shorter",
                                  system_.mechanism.joints[contact.joint].name, 1e3 * motion_.gaps()[k].overrun));
    return;
  }
}

// What goes on with a joint that came apart would be another mechanism.
void StageRun::stop_open() {
  const std::optional<std::size_t> open = motion_.open_closure();
  if (!open || record_.status != StageStatus::finished) return;
  const bool is_angle = system_.tables.closures[*open].kind == ClosureKind::angle;
  const double gap = norm(motion_.equations().workspace.closure_gap[*open]);
  stop("E-NUM-007", fmt::format("{} can no longer be held together, it is open by {}; the other "
                                "joints hold it to second order only, or they leave it no way on",
                                name_closure(system_.mechanism, system_.topology, system_.topology.closures[*open]),
                                is_angle ? fmt::format("{:.3g} deg", gap * 180.0 / std::numbers::pi)
                                         : fmt::format("{:.3g} um", 1e6 * gap)));
}

// All samples that fall into the step just taken; of millions it goes on with the rest when it is called again. False
// when it was stopped before.
bool StageRun::sample_until(double time, const std::stop_token& stop) {
  MotionEquations& equations = motion_.equations();
  scratch_.loads.held = equations.workspace.loads.held;
  for (; n_samples_ < n_all_samples_; ++n_samples_) {
    const double at = warm_up_end_ + static_cast<double>(n_samples_) * sample_step_;
    // The last sample stands at the end, whatever rounding says.
    if (at > time && !(n_samples_ + 1 == n_all_samples_ && time >= end_)) return true;
    if (stop.stop_requested()) return false;
    if (time == 0.0) {
      interpolated_ = motion_.y();
    } else {
      motion_.interpolate(at, interpolated_);
    }
    const double* y = interpolated_.data();
    scratch_.fit(system_.tables);
    equations.eval_in(at, y, scratch_);
    recorder_.sample(at, scratch_, equations.contact_modes, initial_energies_.total(), y + equations.n_states());
  }
  return true;
}

// Steps that shrink because a contact is pressed to where its law ends are told so.
bool StageRun::fail_at_law_end() {
  constexpr double kNear = 1e-3;  // of the penetration there: steps had become shorter than it takes to get there
  const MotionEquations& equations = motion_.equations();
  for (std::size_t k = 0; k < motion_.gaps().size(); ++k) {
    if (!equations.contact_modes[k].in_contact) continue;
    const Contact& contact = system_.tables.contacts[k];
    motion_.evaluate_again();
    const ContactGap& gap = equations.workspace.contact_forces[k].gap;
    const std::optional<NormalForceEnd> end = find_normal_force_end(contact, gap);
    if (!end || gap.penetration < (1.0 - kNear) * end->at.penetration) continue;
    stop("E-NUM-012", fmt::format("joint '{}': its law {} has no force beyond {}{}, at a "
                                  "penetration of {:.4g} um; take a law without an end, or loads that stay below it",
                                  system_.mechanism.joints[contact.joint].name, end->law, end->formula,
                                  std::isfinite(end->at.force) ? fmt::format(" = {:.0f} N", end->at.force) : "",
                                  1e6 * end->at.penetration));
    return true;
  }
  return false;
}

void StageRun::stop(const std::string& code, const std::string& reason) {
  record_.status = StageStatus::failed;
  record_.message = fmt::format("{}: stopped at t = {:.9g} s (cycle {}): {}", code, motion_.time(),
                                static_cast<int>(motion_.time() / record_.cycle_time) + 1, reason);
}

// With what may be the cause, as far as it can be seen.
void StageRun::fail(const std::string& code, const std::string& reason) {
  stop(code, reason);
  if (const int lost =
          find_load_in_the_way(motion_.time(), motion_.find_smallest_step(), motion_.y(), motion_.equations());
      lost >= 0) {
    const Load& load = system_.mechanism.loads[lost];
    record_.message += fmt::format("; load '{}' has no finite value here: {}", load.name,
                                   std::holds_alternative<Spring>(load.kind)
                                       ? "its points coincide, and the direction of its force is lost"
                                       : "look at where its formula or curve is defined");
    return;
  }
  // A law may press from the first touch on, before there is any penetration.
  double deepest = -std::numeric_limits<double>::infinity();
  const std::size_t n_contacts = motion_.gaps().size();
  std::size_t stiffest = n_contacts;
  for (std::size_t k = 0; k < n_contacts; ++k) {
    const double penetration = motion_.gaps()[k].penetration;
    if (motion_.equations().contact_modes[k].in_contact && penetration > deepest) deepest = penetration, stiffest = k;
  }
  motion_.evaluate_again();
  const bool is_singular = find_singular_closeness(system_.tables, motion_.equations().workspace) > kNearlySingular;
  if (stiffest == n_contacts || is_singular) {
    const int closure = find_weakest_closure(system_.tables, motion_.equations().workspace);
    if (closure < 0) return;
    record_.message += fmt::format(
        "; nearest to a singular position: the loop closed by {} - {}",
        name_closure(system_.mechanism, system_.topology, system_.topology.closures[closure]),
        system_.mechanism.drivers.empty() ? "its bars may be in line" : "a driver may ask for more than it can reach");
    return;
  }
  record_.message += fmt::format("; stiffest contact: joint '{}', penetration {:.3g} um, normal force {:.3g} N",
                                 system_.mechanism.joints[system_.tables.contacts[stiffest].joint].name, 1e6 * deepest,
                                 motion_.find_sample(0, stiffest).normal_force);
}

void StageRun::finish() {
  const double now = motion_.time();
  record_.end_time = now;
  record_.solver = motion_.statistics();
  record_.cycles = static_cast<int>(std::max(0.0, now - warm_up_end_) / record_.cycle_time + 1e-9);
  for (std::size_t k = 0; k < motion_.gaps().size(); ++k) {
    const bool ended = motion_.changing_contact() == k;
    if (motion_.equations().contact_modes[k].in_contact && !ended) history_.end(k, now);
  }
  record_.events = std::move(history_.events());
  for (std::size_t g = 0; g < wear_.size(); ++g) {
    const Joint& joint = system_.mechanism.joints[system_.tables.contact_groups[g].joint];
    record_.wear.push_back(wear_[g].summarize(joint.name));
    record_.wear.back().clearance = find_clearance(joint.kind);
  }
  if (record_.status == StageStatus::finished) record_.message = explain_cost();
  // A failed attempt may have left anything in the workspace: evaluate the last accepted state again.
  motion_.evaluate_again();
  const StageRecorder::Energies energies = recorder_.find_energies(motion_.equations().workspace);
  const double* integrals = motion_.y().data() + motion_.equations().n_states();
  EnergyBalance& balance = record_.energy;
  balance.initial_energy = initial_energies_.total();
  balance.kinetic = energies.kinetic;
  balance.potential = energies.potential;
  balance.elastic = energies.elastic;
  balance.driver_work = integrals[kDriverWork];
  balance.load_work = integrals[kLoadWork];
  balance.damper_loss = integrals[kDamperLoss];
  balance.contact_damping = integrals[kContactDamping];
  balance.friction = integrals[kFrictionLoss];
  balance.surface_work = integrals[kSurfaceWork];
  balance.exchanged = integrals[kExchanged];
  balance.load_reach = reach_.largest();
  recorder_.finish(record_);
}

}  // namespace gudgeon
