// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Steps by CVODE, for motions with fast decays: bristles, very stiff contacts, rest.
#pragma once

#include <array>

#include "gudgeon/sim/closure_projection.h"
#include "gudgeon/sim/cvode.h"
#include "gudgeon/sim/error_tolerance.h"
#include "gudgeon/sim/stepper.h"

namespace gudgeon {

/// CVODE sees coordinates, rates and bristles. The integrals, and whatever else is integrated along, are taken by
/// Lobatto's rule of order 6 on its dense output; two of the four stages are the step's ends. A step that is ended
/// earlier ends on dense output, and the next starts anew; so does one after kLongestHistory steps in a row.
class StiffStepper final : public Stepper, private DenseStep, private StiffProblem {
 public:
  static constexpr int kStages = 4;
  /// CVODE's memory cannot be saved. It starts anew so often that a run can be, and so seldom that it costs little.
  static constexpr int kLongestHistory = 1000;

  /// Without projection closures are left alone.
  StiffStepper(MotionEquations& equations, SolverStatistics& statistics, const ErrorTolerance& tolerance,
               ClosureProjection* projection, double longest_step);

  void begin(double time, const std::vector<double>& y, const std::vector<double>& slope, bool continues) override;
  bool attempt(double longest, double left) override;
  void end_at(double h) override;
  void shorten() override;
  void accept() override;
  /// CVODE's history cannot be taken out of it: only where it starts anew.
  [[nodiscard]] bool can_be_saved() const override { return restarts_; }
  [[nodiscard]] bool saves_dense_step() const override { return false; }
  void transfer(StateArchive& archive) override;
  [[nodiscard]] double next_step() const override { return next_; }
  [[nodiscard]] bool projects_closures() const override { return true; }
  [[nodiscard]] const DenseStep& dense() const override { return *this; }
  [[nodiscard]] std::span<const double> nodes() const override;
  [[nodiscard]] std::span<const double> weights() const override;

 private:
  void interpolate(double share, std::size_t n_wanted, double* y) const noexcept override;
  bool eval(double t, const double* y, double* slope) noexcept override;
  void find_weights(const double* y, double* weights) noexcept override;
  bool find_correction(double t, const double* y, double* correction) noexcept override;
  double find_first_step();
  void restart(double first_step);
  void move_to_end();
  void take_stage(int stage);
  void add_integrals(double share, std::size_t n_wanted, double* y) const noexcept;

  const ErrorTolerance& tolerance_;
  ClosureProjection* projection_;
  Cvode cvode_;
  std::vector<double> start_;
  std::vector<double> start_slope_;
  std::vector<double> state_;  // scratch, as large as y
  std::vector<double> slope_;
  std::array<std::array<double, kEnergyIntegrals>, kStages> powers_{};
  double longest_step_;    // [s]
  bool restarts_ = true;   // the next attempt does not continue CVODE's history
  bool is_fresh_ = false;  // no step was taken since CVODE started anew
  bool is_line_ = false;   // too short a step for CVODE: along the slope
  double whole_ = 0.0;     // [s] the attempt before it was ended earlier
  double next_ = 0.0;      // [s]
  long n_failures_ = 0;    // that statistics know of
  int n_steps_ = 0;        // since CVODE started anew
};

}  // namespace gudgeon
