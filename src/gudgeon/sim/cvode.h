// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// SUNDIALS CVODE behind a plain face: backward differentiation of orders 1 to 5 with a dense Newton iteration.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

namespace gudgeon {

/// What CVODE asks for. Nothing here may throw.
class StiffProblem {
 public:
  /// False when the slope is not finite: the step is tried again shorter.
  virtual bool eval(double t, const double* y, double* slope) noexcept = 0;
  /// One over the local error that each component may have.
  virtual void find_weights(const double* y, double* weights) noexcept = 0;
  /// What y lacks to be on the constraints.
  virtual bool find_correction(double t, const double* y, double* correction) noexcept = 0;

 protected:
  ~StiffProblem() = default;
};

/// One internal step at a time, with its interpolation. Order and step length are CVODE's; the state is projected onto
/// the constraints inside a step, so that the history stays whole. Memory is taken at construction. Hindmarsh et al.
/// 2005; projection of Eich 1993.
class Cvode {
 public:
  /// Holds on to the problem. Steps are between `shortest` and `longest` [s].
  Cvode(StiffProblem& problem, std::size_t n, bool projects, double shortest, double longest);
  ~Cvode();

  /// Starts anew, at order 1; zero leaves the first step's length [s] to CVODE.
  void restart(double time, const double* y, double first_step = 0.0);
  /// One step, at most to `stop`; the time it ends at, nothing when there was none.
  std::optional<double> step(double stop);
  /// The solution at a time in the last step.
  void interpolate(double time, std::size_t n_wanted, double* y) const noexcept;
  /// Attempts that failed since the last restart: too large an error, or no convergence.
  [[nodiscard]] long count_failures() const noexcept;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace gudgeon
