// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is to be done with a mechanism: how long, how often it wears, how accurately, in which cases.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gudgeon {

/// Where a step's worn volume goes.
enum class WearDistribution {
  spread,  ///< over the contact arc: conserves k_d F s (default)
  point,   ///< the whole depth into the one cell of the contact point, as in the paper
};

/// How loop closures are held.
enum class Stabilization {
  projection,  ///< positions and velocities projected onto the constraints after accepted steps (default)
  baumgarte,   ///< closure errors fed back into the accelerations, as in the paper
};

/// How motions are integrated.
enum class Integrator {
  automatic,      ///< the explicit pair; with bristles, stiff where its steps are held by stability (default)
  explicit_pair,  ///< Runge-Kutta pair of Tsitouras
  stiff,          ///< backward differentiation
};

/// A value known from elsewhere, set beside ours in the summary: [[study.reference]] of the model file.
struct ReferenceValue {
  std::string quantity;        ///< what it is, in words
  std::string channel;         ///< the channel or joint it belongs to
  std::string measure;         ///< "peak" (signed value of largest magnitude) or "wear_depth" (largest total depth)
  std::vector<double> values;  ///< one a stage, in SI; NaN where none is known
};

struct Study {
  std::string cycle_driver;        ///< one cycle is one turn of this driver; or
  double cycle_time = 0.0;         ///< [s] one cycle
  int cycles = 10;                 ///< cycles a stage that count
  int warm_up_cycles = 0;          ///< cycles before them that are left out of statistics and wear
  int wear_stages = 0;             ///< how often the surfaces are rebuilt; there is one stage more
  double wear_acceleration = 1.0;  ///< a stage's wear times this is what the surfaces lose
  int cells = 1000;                ///< cells of each circumference
  WearDistribution wear_distribution = WearDistribution::spread;
  bool compare_ideal = true;         ///< also run the mechanism with ideal joints
  bool ideal_friction = false;       ///< which then have the friction of the contacts that they replace
  int outputs_per_cycle = 500;       ///< recorded samples a cycle
  double relative_tolerance = 1e-6;  ///< [1] local error a step, of each coordinate and rate
  double absolute_tolerance = 1e-9;  ///< [rad, m, rad/s, m/s] local error a step near zero
  double max_step = 0.0;             ///< [s] largest step; 0 leaves it to the error control
  Integrator integrator = Integrator::automatic;
  Stabilization stabilization = Stabilization::projection;
  double baumgarte_alpha = 5.0;  ///< α [1/s]
  double baumgarte_beta = 5.0;   ///< β [1/s]
  std::vector<ReferenceValue> reference;
};

/// A named variant of the model: overrides of any value, as path and text, "joints.A.radial_clearance" = "0.3 mm".
struct Case {
  std::string name;
  std::string description;
  std::vector<std::pair<std::string, std::string>> overrides;
};

}  // namespace gudgeon
