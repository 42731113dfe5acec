// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whole simulations by every method that is compared, at any tolerance, with what shows how accurate they were.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gudgeon/model/mechanism.h"

namespace gudgeon::bench {

/// What of the motion is compared: a component of a body's centre of mass and angle.
struct Probe {
  std::string body;
  int component = 2;  ///< 0 and 1: x and y [m]; 2: angle [rad]
};

struct RunCase {
  std::string name;
  Mechanism mechanism;
  double cycle_time = 1.0;     ///< [s] steps are at most a fiftieth of it
  double short_horizon = 0.1;  ///< [s] over which motions have not yet parted
  double horizon = 1.0;        ///< [s]
  std::vector<Probe> probes{};
  double wanted_error = 1e-6;     ///< largest error of any probe over the short horizon
  double wanted_residual = 1e-3;  ///< [J] largest energy residual over the whole horizon
};

struct Outcome {
  bool finished = false;
  std::vector<double> samples;     ///< probes at every milestone, one milestone after the other
  std::optional<double> residual;  ///< [J] largest at any milestone, where energies are known
  long evaluations = 0;
  double seconds = 0.0;  ///< [s] of processor time, without building the equations
};

struct Method {
  std::string name;
  std::function<Outcome(double tolerance, double horizon)> run;
};

/// Milestones in a horizon: at these both motion and energies are looked at.
inline constexpr int kMilestones = 20;

std::vector<RunCase> make_run_cases();
/// gudgeon first, by each integrator it offers, then the comparators that can run the case.
std::vector<Method> make_methods(const RunCase& run_case);
/// Largest difference of samples, infinite when a run did not finish.
double find_error(const Outcome& outcome, const Outcome& reference);

}  // namespace gudgeon::bench
