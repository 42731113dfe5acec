// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From step to step: steppers, contact modes, projection, strides.
#include "gudgeon/sim/motion_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gudgeon/system/characteristic_length.h"

namespace gudgeon {

namespace {

// Closure errors above this share of the absolute tolerance are projected away.
constexpr double kProjectionShare = 0.1;
// Beyond this share of the characteristic length a closure is projected, whatever the tolerances.
constexpr double kClosedShare = 5e-10;
// Beyond this share it is open: no rounding and no lenient tolerance leaves so much.
constexpr double kOpenShare = 1e-6;
// A step is at most this share of a cycle, so that no motion of the mechanism is jumped over.
constexpr double kLargestStepShare = 0.02;
// An implicit step that follows on explicit ones held short starts by so much longer.
constexpr double kFirstImplicitLonger = 2.0;
// The first step is this share of a cycle; the error control finds the right one within a few.
constexpr double kFirstStepShare = 1e-5;
// Roundings that separate the end of a last step from the milestone that it was made to end at.
constexpr double kSameTime = 4.0 * std::numeric_limits<double>::epsilon();

std::vector<double> list_bristle_scales(const Tables& tables) {
  std::vector<double> scales;
  for (const Contact& contact : tables.contacts) {
    if (contact.bristle >= 0) scales.push_back(contact.bristle_scale);
  }
  for (const FrictionJoint& joint : tables.friction_joints) {
    if (joint.bristle >= 0) scales.push_back(joint.bristle_scale);
  }
  return scales;
}

}  // namespace

MotionIntegrator::MotionIntegrator(const System& given, const Study& study, double cycle_time)
    : own_system_(has_free_rows(given.tables) ? std::make_unique<System>(given) : nullptr),
      system_(own_system_ ? *own_system_ : given),
      study_(study),
      longest_step_(study.max_step > 0.0 ? std::min(study.max_step, kLargestStepShare * cycle_time)
                                         : kLargestStepShare * cycle_time),
      length_(find_characteristic_length(given.mechanism)),
      equations_(system_, study.stabilization == Stabilization::baumgarte
                              ? Feedback{study.baumgarte_alpha, study.baumgarte_beta}
                              : Feedback{}),
      tolerance_(study, static_cast<std::size_t>(system_.tables.counts.n_free_turns), 2 * equations_.n_free(),
                 list_bristle_scales(system_.tables)),
      projection_(system_.tables, kProjectionShare * study.absolute_tolerance, kClosedShare * length_),
      passage_(equations_.size(), study.absolute_tolerance + study.relative_tolerance),
      events_(system_.tables),
      breaks_(system_, cycle_time, statistics_),
      unseen_(system_),
      scratch_(system_.tables),
      y_(equations_.size(), 0.0),
      slope_(equations_.size(), 0.0),
      gaps_(system_.tables.contacts.size()),
      end_gaps_(system_.tables.contacts.size()),
      passed_(equations_.size()) {
  if (own_system_) row_choice_.emplace(*own_system_);
  // Where all is driven there are works to sum up, and nothing that could be stiff.
  const bool has_states = equations_.n_free() > 0 || system_.tables.n_bristles > 0;
  const bool is_stiff = study.integrator == Integrator::stiff && has_states;
  if (!is_stiff) {
    explicit_ = std::make_unique<ExplicitStepper>(equations_, statistics_, tolerance_, kFirstStepShare * cycle_time);
  }
  const bool may_be_stiff =
      system_.tables.n_bristles > 0 || (!system_.tables.friction_joints.empty() && system_.tables.contacts.empty());
  if (is_stiff || (study.integrator == Integrator::automatic && may_be_stiff && has_states)) {
    const bool projects = study.stabilization == Stabilization::projection && !system_.tables.closures.empty();
    stiff_ = std::make_unique<StiffStepper>(equations_, statistics_, tolerance_, projects ? &projection_ : nullptr,
                                            longest_step_);
  }
  if (study.integrator == Integrator::automatic && !system_.tables.contacts.empty() && !stiff_) {
    implicit_ = std::make_unique<ImplicitStepper>(equations_, statistics_, tolerance_, kFirstStepShare * cycle_time);
  }
  stepper_ = explicit_ ? static_cast<Stepper*>(explicit_.get()) : stiff_.get();
  equations_.time_scale = cycle_time;
  // Where loads are given, works are not known by the motion's own error; where all is driven, there is none.
  const LoadTables& loads = system_.tables.loads;
  if (!loads.expressions.empty() || !loads.curves.empty() || equations_.n_free() == 0) {
    if (explicit_) explicit_->control_works(study.relative_tolerance, study.absolute_tolerance);
    if (implicit_) implicit_->control_works(study.relative_tolerance, study.absolute_tolerance);
  }
}

bool MotionIntegrator::begin(const State& start) {
  std::ranges::copy(start.q, y_.begin());
  std::ranges::copy(start.v, y_.begin() + static_cast<std::ptrdiff_t>(equations_.n_free()));
  evaluate_again();
  settle();
  if (!breaks_.empty() && !change_pieces()) return false;
  equations_.initial_energy = equations_.find_energy();
  events_.find_gaps(equations_.workspace, gaps_);
  return std::ranges::all_of(slope_, [](double s) { return std::isfinite(s); });
}

void MotionIntegrator::evaluate_again() {
  equations_.eval(time_, y_.data(), slope_.data());
  ++statistics_.evaluations;
}

// Goes on with another stepper from where the last step ended.
void MotionIntegrator::use(Stepper& stepper) {
  if (stepper_ == &stepper) return;
  stepper.take_over_end(*stepper_);
  change_to(stepper);
}

// Starts again with another stepper from where the last attempt did.
void MotionIntegrator::retry_with(Stepper& stepper) {
  stepper.take_over_start(*stepper_);
  change_to(stepper);
}

void MotionIntegrator::change_to(Stepper& stepper) {
  stepper_ = &stepper;
  continues_ = false;
  passage_.forget();
}

// After a step, where several steppers may be used.
void MotionIntegrator::choose_stepper() {
  if (last_step_ == 0.0) return;
  if (stepper_ == explicit_.get() && statistics_.accepted_steps % FastestRates::kEvery == 0) {
    rates_.note(last_step_, explicit_->find_stiffness(),
                std::ranges::any_of(equations_.contact_modes, &ContactMode::in_contact));
  }
  if (implicit_) choose_implicit();
  if (!explicit_ || !stiff_) return;
  if (stepper_ == explicit_.get()) {
    if (stiffness_detector_.note_explicit_step(last_step_, explicit_->find_stiffness())) use(*stiff_);
  } else if (stiffness_detector_.note_stiff_step(last_step_, statistics_.evaluations - n_evaluations_)) {
    use(*explicit_);
  }
}

// Whether the explicit step last tried calls for implicit ones, which can be had. A step that slip turns in may have
// jumped over where friction is steep, and so not have felt it: steps to and fro are held short by it all the same.
bool MotionIntegrator::calls_for_implicit() {
  if (!implicit_) return false;
  double stiffness = explicit_->find_stiffness();
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    if (!equations_.contact_modes[k].in_contact || !explicit_->turns_slip(k)) continue;
    stiffness = std::max(stiffness, explicit_->dense().step() * implicit_->find_steepest_decay(k));
  }
  if (!contact_stiffness_detector_.note_explicit_step(stiffness)) return false;
  return std::ranges::count(equations_.contact_modes, true, &ContactMode::in_contact) <= ContactResponse::kMost;
}

void MotionIntegrator::choose_implicit() {
  if (stepper_ == explicit_.get()) {
    if (!calls_for_implicit()) return;
    implicit_->propose(kFirstImplicitLonger * last_step_);
    use(*implicit_);
  } else if (contact_stiffness_detector_.note_implicit_step(last_step_, statistics_.evaluations - n_evaluations_,
                                                            implicit_->find_rates(), implicit_->n_pressing())) {
    explicit_->propose(last_step_);
    use(*explicit_);
  }
}

bool MotionIntegrator::advance(double milestone) {
  choose_stepper();
  n_evaluations_ = statistics_.evaluations;
  if (changing_contact_) switch_contact_mode(*std::exchange(changing_contact_, std::nullopt));
  if (changes_piece_) return change_pieces();
  if (pass_singular_position(milestone)) return true;
  // Steps that are kept to a share of the way to a singular position end on it: time has to go on.
  const double longest = std::min(longest_step_, std::max(passage_.find_longest_step(), find_smallest_step()));
  const double wanted = stepper_->next_step();
  if (time_ >= peak_time_) peak_time_ = std::numeric_limits<double>::infinity();
  if (!breaks_.empty()) milestone = std::min(milestone, next_point_);
  stepper_->begin(time_, y_, slope_, std::exchange(continues_, true));
  while (!attempt_step(longest, std::min(milestone, peak_time_) - time_)) {
    ++statistics_.rejected_steps;
    if (is_out_of_piece_ ? !retry_with_other_pieces() : !prepare_retry()) return false;
  }
  accept(std::min(milestone, peak_time_));
  if (time_ == next_point_) {
    changes_piece_ = true;
    stepper_->propose(std::max(wanted, stepper_->next_step()));
  }
  return true;
}

// After an attempt that was given up: with another stepper where this one cannot go on, or would go on in short steps.
// False when nothing more can be done.
bool MotionIntegrator::prepare_retry() {
  const bool is_explicit = stepper_ == explicit_.get();
  if (stepper_->next_step() < find_smallest_step()) {
    if (is_explicit || !explicit_) return false;
    stiffness_detector_.forget();
    retry_with(*explicit_);
    evaluate_again();
  } else if (is_explicit && calls_for_implicit()) {
    implicit_->propose(kFirstImplicitLonger * explicit_->next_step());
    retry_with(*implicit_);
  } else {
    return true;
  }
  stepper_->begin(time_, y_, slope_, false);
  continues_ = true;
  return true;
}

// Strides over a singular position that lies ahead. Where surfaces might meet, no step is taken unseen.
bool MotionIntegrator::pass_singular_position(double milestone) {
  if (!gaps_.empty()) return false;
  const std::optional<double> far_side = passage_.find_far_side();
  if (!far_side || *far_side >= milestone || passes_break(*far_side)) return false;
  passage_.interpolate(*far_side, y_);
  time_ = *far_side;
  last_step_ = 0.0;
  strode_ = true;
  continues_ = false;
  evaluate_again();
  settle();
  passage_.forget();
  changes_piece_ = !breaks_.empty();
  return true;
}

void MotionIntegrator::switch_contact_mode(std::size_t k) {
  ContactMode& mode = equations_.contact_modes[k];
  passage_.forget();
  stiffness_detector_.forget();
  contact_stiffness_detector_.forget();
  if (explicit_) use(*explicit_);
  continues_ = false;
  const bool has_bristle = system_.tables.contacts[k].bristle >= 0;
  if (mode.in_contact) {
    mode = {};
    gaps_[k] = events_.find_gap(k, equations_.workspace);
    stepper_->forget_samples(k);  // the other stepper takes them over
    if (has_bristle) y_[equations_.bristle_at(k)] = 0.0;
    ++statistics_.separations;
  } else {
    mode = {true, gaps_[k].penetration_rate};
    stepper_->note_onset();
    ++statistics_.onsets;
  }
  // Most forces are zero on both sides of the change; a bristle's rate is not.
  if (has_bristle || system_.tables.contacts[k].steps_at_onset) evaluate_again();
}

void MotionIntegrator::accept(double milestone) {
  stepper_->accept();
  const double h = stepper_->dense().step();
  const double end_time = stepper_->dense().start_time() + h;
  ++statistics_.accepted_steps;
  // Two contacts may change at one instant, with no time between.
  if (h > 0.0) {
    statistics_.smallest_step = statistics_.smallest_step > 0.0 ? std::min(statistics_.smallest_step, h) : h;
  }
  statistics_.largest_step = std::max(statistics_.largest_step, h);

  time_ = std::abs(end_time - milestone) <= kSameTime * milestone ? milestone : end_time;
  last_step_ = h;
  y_ = stepper_->end();
  slope_ = stepper_->end_slope();
  strode_ = false;
  changes_piece_ = located_ > 0.0 && located_ == h;
  // Gaps at a change of contact are where they have to be: its closures wait for the next step.
  if (!changing_contact_ && !changes_piece_ && settle() > 0)
    events_.find_gaps(equations_.workspace, equations_.contact_modes, end_gaps_);
  std::swap(gaps_, end_gaps_);
  if (!changing_contact_) choose_rows();
  if (!stepper_->projects_closures()) {
    passage_.note(time_, y_, slope_, find_singular_closeness(system_.tables, equations_.workspace));
  }
}

// Closes the loops of the accepted state; returns how often it was corrected.
int MotionIntegrator::settle() {
  statistics_.closure_residual = std::max(statistics_.closure_residual, find_largest(equations_.workspace.closure_gap));
  if (study_.stabilization == Stabilization::baumgarte || stepper_->projects_closures()) return 0;
  const int n_corrections = projection_.project(time_, y_, slope_, equations_);
  statistics_.projections += n_corrections;
  statistics_.evaluations += n_corrections;
  return n_corrections;
}

// The motion is the same whichever rows are enforced; only its equations are others.
void MotionIntegrator::choose_rows() {
  while (row_choice_ && row_choice_->update(*own_system_, equations_.workspace)) {
    scratch_.fit(system_.tables);
    evaluate_again();
    note_usual_pivots(own_system_->tables, equations_.workspace);
    passage_.forget();
    continues_ = false;
  }
}

std::optional<std::size_t> MotionIntegrator::open_closure() const {
  const std::vector<Vec2>& gaps = equations_.workspace.closure_gap;
  for (std::size_t c = 0; c < gaps.size(); ++c) {
    const double unit = system_.tables.closures[c].kind == ClosureKind::angle ? 1.0 : length_;
    if (!(norm(gaps[c]) <= kOpenShare * unit)) return c;
  }
  return std::nullopt;
}

void MotionIntegrator::transfer(StateArchive& archive) {
  if (own_system_) transfer_rows(archive, *own_system_);
  equations_.workspace.fit(system_.tables);
  scratch_.fit(system_.tables);
  archive(equations_, passage_, breaks_, unseen_, scratch_, statistics_);
  transfer_stepper(archive);
  archive(stiffness_detector_, contact_stiffness_detector_, rates_, n_evaluations_, time_, last_step_, strode_,
          continues_, y_, slope_);
  archive(gaps_, end_gaps_, changing_contact_, passed_, changes_piece_, is_out_of_piece_, located_, next_point_);
  archive(peak_time_);
}

void MotionIntegrator::transfer_stepper(StateArchive& archive) {
  const std::array<Stepper*, 3> steppers{explicit_.get(), implicit_.get(), stiff_.get()};
  auto at_work = static_cast<std::size_t>(std::ranges::find(steppers, stepper_) - steppers.begin());
  archive(at_work);
  if (at_work >= steppers.size() || steppers[at_work] == nullptr) StateArchive::refuse();
  stepper_ = steppers[at_work];
  for (Stepper* stepper : steppers) {
    if (stepper != nullptr) stepper->transfer(archive);
  }
}

void MotionIntegrator::interpolate(double time, std::vector<double>& y) const {
  if (strode_) {
    passage_.interpolate(time, y);
    return;
  }
  if (last_step_ == 0.0) {
    y = y_;
    return;
  }
  const double share = (time - stepper_->dense().start_time()) / last_step_;
  stepper_->dense().interpolate(std::clamp(share, 0.0, 1.0), y.size(), y.data());
}

}  // namespace gudgeon
