// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Evenly spaced places, and both sides of every jump between them.
#include "gudgeon/sim/function_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "gudgeon/model/cycle_time.h"
#include "gudgeon/system/characteristic_length.h"
#include "gudgeon/system/load_forces.h"
#include "gudgeon/system/motion_function.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

namespace {

constexpr int kFormulaPlaces = 4000;
constexpr int kCurvePlaces = 4000;
constexpr int kMostBetweenPoints = 16;
constexpr double kBeyondShare = 0.05;  // of a curve's length, on either side

struct Range {
  double begin = 0.0;
  double end = 0.0;
};

class FunctionSampler {
 public:
  FunctionSampler(const Mechanism& mechanism, const Study& study, const Assembly& assembly)
      : system_(compile(mechanism, assembly)),
        workspace_(system_.tables),
        cycle_time_(find_cycle_time(mechanism, study)),
        duration_(cycle_time_ * (study.cycles + study.warm_up_cycles)),
        length_(find_characteristic_length(mechanism)) {
    const State start = make_state(system_, assembly);
    update_coordinates(system_.tables, 0.0, start.q.data(), start.v.data(), workspace_.coordinates);
    update_point_motions(system_.tables, workspace_);
    update_breaks(system_.tables, 0.0, workspace_);
  }

  std::vector<FunctionSamples> sample() {
    const LoadTables& loads = system_.tables.loads;
    for (const ForceLoad& force : loads.forces) {
      add_load(force.load, force.x, "force.0", "force in x", "N");
      add_load(force.load, force.y, "force.1", "force in y", "N");
    }
    for (const TorqueLoad& torque : loads.torques) add_load(torque.load, torque.torque, "torque", "torque", "N m");
    for (const DrivenMotion& driven : system_.tables.driven) {
      if (!driven.is_uniform()) add_motion(driven);
    }
    return std::move(samples_);
  }

 private:
  void add_load(int load, const LoadFunction& function, const char* key, const char* what, const char* unit) {
    const std::string& name = system_.mechanism.loads[static_cast<std::size_t>(load)].name;
    FunctionSamples samples;
    samples.id = fmt::format("loads.{}.{}", name, key);
    samples.subject = fmt::format("load '{}'", name);
    samples.what = what;
    samples.unit = unit;
    if (function.curve >= 0) add_curve(std::move(samples), find_given_curve(load, key), function);
    if (function.expression >= 0) add_formulas(samples, static_cast<std::size_t>(function.expression));
  }

  // The points as they were given; the tables have only the curve.
  const SampledCurve& find_given_curve(int load, std::string_view key) const {
    const AnyLoad& any = system_.mechanism.loads[static_cast<std::size_t>(load)].kind;
    if (const auto* torque = std::get_if<VariableTorque>(&any)) return std::get<SampledCurve>(torque->torque);
    const auto& force = std::get<VariableForce>(any);
    return std::get<SampledCurve>(key == "force.0" ? force.x : force.y);
  }

  void add_curve(FunctionSamples samples, const SampledCurve& given, const LoadFunction& function) {
    const Curve& curve = system_.tables.loads.curves[static_cast<std::size_t>(function.curve)];
    samples.arguments = list_curve_places(given);
    for (const double x : samples.arguments) samples.values.push_back(curve.eval(x).value);
    add_points(std::move(samples), given);
  }

  void add_points(FunctionSamples samples, const SampledCurve& given) {
    samples.over = given.over;
    samples.over_unit = si_unit(find_channel_dimension(given.over).value_or(dimension::kTime));
    samples.point_arguments = given.arguments;
    samples.point_values = given.values;
    samples_.push_back(std::move(samples));
  }

  static std::vector<double> list_curve_places(const SampledCurve& given) {
    const std::vector<double>& x = given.arguments;
    const double beyond = kBeyondShare * (x.back() - x.front());
    const int n_between = std::clamp(kCurvePlaces / static_cast<int>(x.size()), 2, kMostBetweenPoints);
    std::vector<double> places;
    const auto add = [&](double begin, double end) {
      for (int i = 0; i < n_between; ++i) places.push_back(begin + (end - begin) * i / n_between);
    };
    add(x.front() - beyond, x.front());
    for (std::size_t k = 0; k + 1 < x.size(); ++k) add(x[k], x[k + 1]);
    add(x.back(), x.back() + beyond);
    places.push_back(x.back() + beyond);
    return places;
  }

  void add_formulas(const FunctionSamples& base, std::size_t expression) {
    ExpressionEvaluator& formula = workspace_.loads.evaluators[expression];
    const LoadTables& loads = system_.tables.loads;
    for (const int channel : formula.used_variables()) {
      const auto k = static_cast<std::size_t>(channel);
      FunctionSamples samples = base;
      samples.is_formula = true;
      samples.over = loads.channel_names[k];
      samples.over_unit = si_unit(find_channel_dimension(samples.over).value_or(dimension::kNone));
      const std::vector<double>& start = workspace_.loads.channel_values;
      const Range range = find_range(loads.channels[k].quantity, start[k]);
      if (formula.used_variables().size() == 1) {
        add_formula(formula, start, k, range, samples);
        continue;
      }
      for (const auto& [others, share] : {std::pair{"at the start", 0.0}, {"below it", -0.5}, {"above it", 0.5}}) {
        samples.others = others;
        add_formula(formula, shift_inputs(start, share), k, range, samples);
      }
    }
  }

  // All channels by that share of how far they are shown from the start; time does not go back.
  [[nodiscard]] std::vector<double> shift_inputs(std::vector<double> inputs, double share) const {
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const Range range = find_range(system_.tables.loads.channels[k].quantity, inputs[k]);
      inputs[k] = std::max(inputs[k] + share * 0.5 * (range.end - range.begin), range.begin);
    }
    return inputs;
  }

  void add_formula(ExpressionEvaluator& formula, std::vector<double> inputs, std::size_t running, Range range,
                   FunctionSamples samples) {
    sample_formula(formula, inputs, running, range, samples);
    samples_.push_back(std::move(samples));
  }

  [[nodiscard]] Range find_range(StateChannel::Quantity quantity, double start) const {
    using enum StateChannel::Quantity;
    const double rate = 2.0 * std::numbers::pi / cycle_time_;
    const auto around = [&](double reach) { return Range{start - reach, start + reach}; };
    switch (quantity) {
      case time:
        return {0.0, duration_};
      case angle:
        return around(std::numbers::pi);
      case angle_rate:
        return around(rate);
      case x_velocity:
      case y_velocity:
      case speed:
        return around(rate * length_);
      default:
        return around(length_);
    }
  }

  // With `inputs` for what it depends on, of which one runs over the range.
  static void sample_formula(ExpressionEvaluator& formula, std::vector<double>& inputs, std::size_t running,
                             Range range, FunctionSamples& samples) {
    std::vector<BreakState> breaks(formula.breaks().size());
    const auto eval = [&](double x) {
      inputs[running] = x;
      const double value = formula.eval(inputs.data(), nullptr, breaks.data());
      std::vector<int> pieces;
      for (const BreakState& one : breaks) pieces.push_back(one.met ? one.piece : kFreePiece);
      return std::pair{value, std::move(pieces)};
    };
    const auto add = [&](double x, double value) {
      samples.arguments.push_back(x);
      samples.values.push_back(value);
    };
    auto before = eval(range.begin);
    add(range.begin, before.first);
    for (int i = 1; i <= kFormulaPlaces; ++i) {
      double below = range.begin + (range.end - range.begin) * (i - 1) / kFormulaPlaces;
      const double place = range.begin + (range.end - range.begin) * i / kFormulaPlaces;
      auto here = eval(place);
      if (here.second != before.second) {
        double above = place;
        for (double middle = std::midpoint(below, above); middle > below && middle < above;
             middle = std::midpoint(below, above)) {
          (eval(middle).second == before.second ? below : above) = middle;
        }
        add(below, eval(below).first);
        add(above, eval(above).first);
      }
      add(place, here.first);
      before = std::move(here);
    }
  }

  void add_motion(const DrivenMotion& driven) {
    const Driver& driver = system_.mechanism.drivers[static_cast<std::size_t>(driven.driver)];
    const bool turns = std::holds_alternative<DrivenAngle>(driver.target);
    FunctionSamples motion;
    motion.id = fmt::format("drivers.{}.motion", driver.name);
    motion.subject = fmt::format("driver '{}'", driver.name);
    motion.what = "motion";
    motion.unit = turns ? "rad" : "m";
    motion.over = "t";
    motion.over_unit = "s";
    MotionFunction function(driven);
    const auto add_acceleration = [&] {
      FunctionSamples acceleration = samples_.back();
      acceleration.id += ".acceleration";
      acceleration.what = "acceleration";
      acceleration.unit += "/s^2";
      acceleration.point_arguments.clear();
      acceleration.point_values.clear();
      std::ranges::transform(acceleration.arguments, acceleration.values.begin(),
                             [&](double t) { return function.eval(t).acceleration; });
      samples_.push_back(std::move(acceleration));
    };
    if (const auto* given = std::get_if<SampledCurve>(&driver.motion)) {
      const Curve curve = make_motion_curve(*given);
      motion.arguments = list_curve_places(*given);
      for (const double t : motion.arguments) motion.values.push_back(curve.eval(t).value);
      add_points(std::move(motion), *given);
    } else {
      const auto& expression = std::get<Expression>(driver.motion);
      ExpressionEvaluator formula(expression.text, expression.constants, {"t"});
      std::vector<double> inputs{0.0};
      motion.is_formula = true;
      sample_formula(formula, inputs, 0, {0.0, duration_}, motion);
      samples_.push_back(std::move(motion));
    }
    add_acceleration();
  }

  System system_;
  Workspace workspace_;
  double cycle_time_;
  double duration_;
  double length_;
  std::vector<FunctionSamples> samples_;
};

}  // namespace

std::vector<FunctionSamples> sample_functions(const Mechanism& mechanism, const Study& study,
                                              const Assembly& assembly) {
  return FunctionSampler(mechanism, study, assembly).sample();
}

}  // namespace gudgeon
