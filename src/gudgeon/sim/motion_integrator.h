// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From one accepted step to the next.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "gudgeon/model/study.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/sim/closure_projection.h"
#include "gudgeon/sim/contact_events.h"
#include "gudgeon/sim/contact_stiffness_detector.h"
#include "gudgeon/sim/error_tolerance.h"
#include "gudgeon/sim/explicit_stepper.h"
#include "gudgeon/sim/fastest_rates.h"
#include "gudgeon/sim/implicit_stepper.h"
#include "gudgeon/sim/load_breaks.h"
#include "gudgeon/sim/motion_equations.h"
#include "gudgeon/sim/singular_passage.h"
#include "gudgeon/sim/stiff_stepper.h"
#include "gudgeon/sim/stiffness_detector.h"
#include "gudgeon/sim/unseen_loads.h"
#include "gudgeon/system/row_choice.h"

namespace gudgeon {

/// Advances one motion. Steps are controlled by their local error and the energy balance; a contact's change ends its
/// step, an onset being located just before the surfaces touch, and its speed kept; loop closures are
/// projected when they need it. Allocates nothing after construction, but where closure rows are exchanged.
class MotionIntegrator {
 public:
  /// Keeps references to both.
  MotionIntegrator(const System& system, const Study& study, double cycle_time);
  MotionIntegrator(const System&&, const Study&, double) = delete;
  MotionIntegrator(const System&, const Study&&, double) = delete;
  MotionIntegrator(const MotionIntegrator&) = delete;  // its steppers hold on to its equations
  MotionIntegrator& operator=(const MotionIntegrator&) = delete;

  /// Takes a state at time zero; false when it does not determine the accelerations.
  bool begin(const State& start);

  /// One accepted step, at most to the milestone, which is hit exactly. False when the step would fall below
  /// the smallest; the last accepted state then stays.
  bool advance(double milestone);

  /// What moves: the system given, or a copy of it where its closure rows are chosen anew as it moves.
  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] double time() const { return time_; }
  /// Shorter steps than this [s] are given up.
  [[nodiscard]] double find_smallest_step() const noexcept { return gudgeon::find_smallest_step(time_, longest_step_); }
  [[nodiscard]] const std::vector<double>& y() const { return y_; }
  /// ẏ there, with the contact modes of the step that ended.
  [[nodiscard]] const std::vector<double>& slope() const { return slope_; }
  /// Equations, contact modes and workspace, evaluated at the end of the step.
  [[nodiscard]] MotionEquations& equations() { return equations_; }
  [[nodiscard]] const std::vector<GapState>& gaps() const { return gaps_; }
  [[nodiscard]] const SolverStatistics& statistics() const { return statistics_; }

  /// Length of the last step [s]; zero after a stride over a singular position, which has no stages, and between two
  /// contacts that change at one instant.
  [[nodiscard]] double last_step() const { return last_step_; }
  /// Whether the last step was implicit in the forces of contacts.
  [[nodiscard]] bool is_implicit() const { return implicit_ && stepper_ == implicit_.get(); }
  /// What took the last step: knows its stages, at which contacts are sampled.
  [[nodiscard]] const Stepper& stepper() const { return *stepper_; }
  /// What a contact was like at a stage of the last step; without force where it was open.
  [[nodiscard]] const ContactSample& find_sample(int stage, std::size_t contact) const {
    return stepper_->find_sample(stage, contact);
  }
  /// The contact that changes at the end of the step. Its mode is switched when the next step begins.
  [[nodiscard]] std::optional<std::size_t> changing_contact() const { return changing_contact_; }
  /// A closure that can no longer be kept closed: it is open by more than a millionth of the characteristic length, or
  /// off by more than a millionth of a radian.
  [[nodiscard]] std::optional<std::size_t> open_closure() const;
  /// Whether a load goes to another piece of its formula or curve at the end of the step. It does so in a step of no
  /// length that follows.
  [[nodiscard]] bool changes_piece() const { return changes_piece_; }
  /// How often loads went to another piece of a formula or curve.
  [[nodiscard]] std::int64_t n_piece_changes() const { return breaks_.n_changes(); }
  /// Why no piece of a load could be gone into, when advance() failed for that.
  [[nodiscard]] const std::optional<LoadBreaks::Stall>& stall() const { return stall_; }
  /// How fast the fastest part of the motion was in explicit steps.
  [[nodiscard]] const FastestRates& rates() const { return rates_; }
  /// The state at a time within the last step.
  void interpolate(double time, std::vector<double>& y) const;

  /// Whether a motion that is loaded from what transfer() saves goes on with the same bits.
  [[nodiscard]] bool can_be_saved() const { return !continues_ || stepper_->can_be_saved(); }
  /// Whether interpolate() does so, too.
  [[nodiscard]] bool saves_last_step() const { return strode_ || stepper_->saves_dense_step(); }
  /// Of a motion that has begun.
  void transfer(StateArchive& archive);

  /// Evaluates the last accepted state again, whatever was tried since.
  void evaluate_again();

 private:
  void use(Stepper& stepper);
  void retry_with(Stepper& stepper);
  void change_to(Stepper& stepper);
  void choose_stepper();
  void choose_implicit();
  bool calls_for_implicit();
  bool prepare_retry();
  bool pass_singular_position(double milestone);
  bool attempt_step(double longest, double left);
  void find_end_gaps();
  [[nodiscard]] bool is_gap_passed() const;
  bool locate_change(const ContactChange& change);
  void switch_contact_mode(std::size_t contact);
  bool end_at_break();
  bool sees_loads();
  bool locate_break(const LoadBreaks::Leave& leave);
  bool change_pieces();
  bool retry_with_other_pieces();
  bool passes_break(double far_side);
  void accept(double milestone);
  int settle();
  void choose_rows();
  void transfer_stepper(StateArchive& archive);

  std::unique_ptr<System> own_system_;  // where rows are chosen anew
  const System& system_;
  const Study& study_;
  double longest_step_;  // [s]
  double length_;        // [m] characteristic
  MotionEquations equations_;
  ErrorTolerance tolerance_;
  ClosureProjection projection_;
  std::optional<RowChoice> row_choice_;  // where constraints imply each other
  SingularPassage passage_;
  ContactEvents events_;
  LoadBreaks breaks_;
  UnseenLoads unseen_;
  Workspace scratch_;
  SolverStatistics statistics_;
  std::unique_ptr<ExplicitStepper> explicit_;  // the steppers that the study permits
  std::unique_ptr<ImplicitStepper> implicit_;
  std::unique_ptr<StiffStepper> stiff_;
  Stepper* stepper_ = nullptr;  // the one at work
  StiffnessDetector stiffness_detector_;
  ContactStiffnessDetector contact_stiffness_detector_;
  FastestRates rates_;
  std::int64_t n_evaluations_ = 0;  // before the last step

  double time_ = 0.0;
  double last_step_ = 0.0;
  bool strode_ = false;     // over a singular position, in the last step
  bool continues_ = false;  // the next step follows on the last one, with neither state nor contact modes changed
  std::vector<double> y_;
  std::vector<double> slope_;
  std::vector<GapState> gaps_;      // at the last accepted state
  std::vector<GapState> end_gaps_;  // at the end of an attempt
  std::optional<std::size_t> changing_contact_;
  std::vector<double> passed_;                                  // a state within a stride
  bool changes_piece_ = false;                                  // a load, at the end of the step
  bool is_out_of_piece_ = false;                                // a load, from the first moment of the attempt on
  double located_ = 0.0;                                        // [s] length of an attempt that ends on a break
  double next_point_ = 0.0;                                     // [s] time of the next point of curves over the time
  double peak_time_ = std::numeric_limits<double>::infinity();  // [s] of a load that a step has not seen
  std::optional<LoadBreaks::Stall> stall_;
};

}  // namespace gudgeon
