// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is to be done with a mechanism: how long, how often it wears, how accurately, in which cases.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gudgeon/model/field.h"

namespace gudgeon {

/// Where a step's worn volume goes.
enum class WearDistribution {
  spread,  ///< over the contact arc: conserves k_d F s (default)
  point,   ///< the whole depth into the one cell of the contact point, as in the paper
};

inline constexpr std::array<std::pair<std::string_view, WearDistribution>, 2> kWearDistributions{{
    {"spread", WearDistribution::spread},
    {"point", WearDistribution::point},
}};
constexpr std::span<const std::pair<std::string_view, WearDistribution>> choices(WearDistribution /*kind*/) {
  return kWearDistributions;
}

/// How loop closures are held.
enum class Stabilization {
  projection,  ///< positions and velocities projected onto the constraints after accepted steps (default)
  baumgarte,   ///< closure errors fed back into the accelerations, as in the paper
};

inline constexpr std::array<std::pair<std::string_view, Stabilization>, 2> kStabilizations{{
    {"projection", Stabilization::projection},
    {"baumgarte", Stabilization::baumgarte},
}};
constexpr std::span<const std::pair<std::string_view, Stabilization>> choices(Stabilization /*kind*/) {
  return kStabilizations;
}

/// How motions are integrated.
enum class Integrator {
  automatic,      ///< the explicit pair; with bristles, stiff where its steps are held by stability (default)
  explicit_pair,  ///< Runge-Kutta pair of Tsitouras
  stiff,          ///< backward differentiation
};

inline constexpr std::array<std::pair<std::string_view, Integrator>, 3> kIntegrators{{
    {"automatic", Integrator::automatic},
    {"explicit", Integrator::explicit_pair},
    {"stiff", Integrator::stiff},
}};
constexpr std::span<const std::pair<std::string_view, Integrator>> choices(Integrator /*kind*/) { return kIntegrators; }

/// A value known from elsewhere, set beside ours in the summary: [[study.reference]] of the model file.
struct ReferenceValue {
  std::string quantity;        ///< what it is, in words
  std::string channel;         ///< the channel or joint it belongs to
  std::string measure;         ///< "peak" (signed value of largest magnitude) or "wear_depth" (largest total depth)
  std::vector<double> values;  ///< one a stage, in SI; NaN where none is known

  static constexpr std::string_view kMeaning = "a value known from elsewhere, set beside ours in the summary";
  static constexpr auto kFields = std::tuple{
      field("quantity", &ReferenceValue::quantity, {.required = true, .meaning = "what it is, in words"}),
      field("channel", &ReferenceValue::channel,
            {.required = true, .names = Names::channel, .meaning = "the channel or joint it belongs to"}),
      field("measure", &ReferenceValue::measure,
            {.required = true,
             .meaning = "\"peak\", the signed value of largest magnitude, or \"wear_depth\", the largest total depth"}),
      field("values", &ReferenceValue::values, {.required = true, .meaning = "one per stage; nan where none is known"}),
  };
};

/// A count of at least so many.
constexpr FieldTraits count_from(double minimum, std::string_view meaning) {
  return {.range = {minimum, kUnbounded, false, true}, .code = "E-STUDY-005", .meaning = meaning};
}

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

  /// Below 1e-15 nothing is left of a double; above 1e-2 nothing of the motion.
  static constexpr ParameterRange kTolerance{1e-15, 1e-2};

  static constexpr std::string_view kMeaning = "how long, how often it wears, how accurately";
  /// What a cycle is: one excludes the other.
  static constexpr auto kCycleFields = std::tuple{
      field("cycle_driver", &Study::cycle_driver,
            {.names = Names::driver,
             .absent = "the first that turns a body",
             .meaning = "one cycle is one turn of this driver"}),
      field("cycle_time", &Study::cycle_time,
            {.dimension = dimension::kTime,
             .range = kPositive,
             .absent = "1 s without such a driver",
             .meaning = "one cycle, in place of cycle_driver"}),
  };
  static constexpr auto kFields = std::tuple{
      field("cycles", &Study::cycles, count_from(1, "per stage that count")),
      field("warm_up_cycles", &Study::warm_up_cycles,
            count_from(0, "per stage before them that are left out of statistics and wear")),
      field("wear_stages", &Study::wear_stages,
            count_from(0, "how often the surfaces are rebuilt; there is one stage more")),
      field("wear_acceleration", &Study::wear_acceleration,
            {.range = kPositive,
             .code = "E-STUDY-006",
             .meaning = "a stage's wear times this is what the surfaces lose"}),
      field("cells", &Study::cells,
            {.range = {10, 1e6}, .code = "E-STUDY-005", .meaning = "of each circumference or slot side, for wear"}),
      field("wear_distribution", &Study::wear_distribution,
            {.meaning = "of a step's worn volume: over the contact arc, or into the cell of the contact point"}),
      field("compare_ideal", &Study::compare_ideal, {.meaning = "also run the mechanism with ideal joints"}),
      field("ideal_friction", &Study::ideal_friction,
            {.meaning = "which then have the friction of the contacts that they replace, on the journal's sizes"}),
      field("outputs_per_cycle", &Study::outputs_per_cycle, count_from(1, "recorded samples per cycle")),
      field(
          "relative_tolerance", &Study::relative_tolerance,
          {.range = kTolerance, .code = "E-STUDY-006", .meaning = "local error per step, of each coordinate and rate"}),
      field("absolute_tolerance", &Study::absolute_tolerance,
            {.range = kTolerance, .code = "E-STUDY-006", .meaning = "local error per step near zero, in SI"}),
      field("max_step", &Study::max_step,
            {.dimension = dimension::kTime,
             .range = kNotNegative,
             .code = "E-STUDY-006",
             .meaning = "largest step; 0 leaves it to the error control"}),
      field("integrator", &Study::integrator,
            {.meaning = "explicit, implicit in contact forces where journals stick, stiff where bristles hold steps "
                        "short; or one "
                        "of them alone"}),
      field(
          "stabilization", &Study::stabilization,
          {.meaning = "how loops are held closed: projected after accepted steps, or fed back into the accelerations"}),
      field("baumgarte_alpha", &Study::baumgarte_alpha,
            {.dimension = dimension::kPerTime,
             .symbol = "α",
             .range = kNotNegative,
             .code = "E-STUDY-006",
             .meaning = "of baumgarte"}),
      field("baumgarte_beta", &Study::baumgarte_beta,
            {.dimension = dimension::kPerTime,
             .symbol = "β",
             .range = kNotNegative,
             .code = "E-STUDY-006",
             .meaning = "of baumgarte"}),
      field("reference", &Study::reference,
            {.absent = "none", .meaning = "values known from elsewhere, [[study.reference]]"}),
  };
};

/// A named variant of the model: overrides of any value, as path and text, "joints.A.radial_clearance" = "0.3 mm".
struct Case {
  std::string name;
  std::string description;
  std::vector<std::pair<std::string, std::string>> overrides;
};

}  // namespace gudgeon
