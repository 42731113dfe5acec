// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Steps that are implicit in the forces of contacts: for friction that turns within a hair of slip.
#pragma once

#include <array>

#include "gudgeon/sim/controlled_stepper.h"
#include "gudgeon/sim/esdirk.h"
#include "gudgeon/system/contact_response.h"

namespace gudgeon {

/// Each stage of Esdirk is solved for its accelerations a: with rates v = v* + γh a and coordinates q = q* + γh v,
/// a = f(t, q, v). What f lacks of a is corrected by the answer of the pressing contacts alone, which is all that is
/// stiff; the rest comes by itself. For motions without bristles.
class ImplicitStepper final : public ControlledStepper, private DenseStep {
 public:
  ImplicitStepper(MotionEquations& equations, SolverStatistics& statistics, const ErrorTolerance& tolerance,
                  double first_step);

  void begin(double time, const std::vector<double>& y, const std::vector<double>& slope, bool continues) override;
  void end_at(double h) override;
  void accept() override;
  void transfer(StateArchive& archive) override {
    ControlledStepper::transfer(archive);
    transfer_times(archive);
    archive(response_, start_, error_, slopes_, past_, past_times_, base_, acceleration_, residual_, slope_);
    archive(has_past_, has_response_);
  }
  /// The fastest rates that contacts put into the motion at the end of the last step.
  [[nodiscard]] ContactRates find_rates() const noexcept {
    return response_.find_rates(equations_.contact_modes, equations_.workspace);
  }
  /// How fast slip of a contact comes to rest where friction is steepest, by the forces of the workspace as it stands.
  [[nodiscard]] double find_steepest_decay(std::size_t contact) noexcept {
    response_.update(equations_.workspace);
    has_response_ = true;
    return response_.find_steepest_decay(contact, equations_.workspace);
  }
  /// How many contacts press there.
  [[nodiscard]] int n_pressing() const noexcept { return response_.n_pressing(); }
  [[nodiscard]] const DenseStep& dense() const override { return *this; }
  [[nodiscard]] std::span<const double> weights() const override { return Esdirk::kWeights; }
  [[nodiscard]] std::span<const double> nodes() const override { return Esdirk::kNodes; }
  [[nodiscard]] std::span<const double> shares() const override { return Esdirk::kShares; }

 private:
  static constexpr int kPast = 2;  // stages of the last step that the next one's are guessed from

  [[nodiscard]] AttemptedStep describe_attempt() const override { return {h_, start_, end_, error_}; }
  [[nodiscard]] double find_error(std::size_t component) const override;
  void interpolate(double share, std::size_t n_wanted, double* y) const noexcept override;
  bool solve_stage(int stage) noexcept;
  void guess_accelerations(int stage) noexcept;
  [[nodiscard]] double find_size(double tau) const noexcept;

  const ErrorTolerance& tolerance_;
  ContactResponse response_;
  std::size_t n_free_;
  std::vector<double> start_;
  std::vector<double> error_;
  std::array<std::vector<double>, Esdirk::kStages> slopes_;  // [rates | accelerations | powers] of the stages
  std::array<std::vector<double>, kPast> past_;              // accelerations
  std::array<double, kPast> past_times_{};                   // [s] against the start of the step
  std::vector<double> base_;                                 // [q* | v*]
  std::vector<double> acceleration_;
  std::vector<double> residual_;
  std::vector<double> slope_;
  bool has_past_ = false;
  bool has_response_ = false;
};

}  // namespace gudgeon
