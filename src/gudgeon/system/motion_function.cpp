// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Central differences, and the step that serves them best.
#include "gudgeon/system/motion_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/model/cycle_time.h"

namespace gudgeon {

namespace {

// Weights of f(t ± k h), k = 1 … 4. The second derivative is summed over differences to f(t), which are exact.
constexpr std::array kFirst8{4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
constexpr std::array kSecond8{8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0};
constexpr std::array kSecond6{3.0 / 2.0, -3.0 / 20.0, 1.0 / 90.0, 0.0};
constexpr std::array kSecond4{4.0 / 3.0, -1.0 / 12.0, 0.0, 0.0};
constexpr int kReach = 4;

// What rounding of f and of its argument contributes to the second derivative, in units of ε (|f| + |t ḟ|) / h²: the
// root of the sum of the squares of the weights is 3.7.
constexpr double kRounding = 4.0;
// Above this share of the motion's own accelerations the differences do not converge: a jump or a kink is near.
constexpr double kLeastSmoothness = 1e-6;
// Steps are the cycle over powers of two. The search starts where any motion that turns less than a thousand times a
// cycle is resolved: coarser grids could take a fast oscillation for a slow one.
constexpr int kFirstHalving = 14;
constexpr int kFinestHalving = 18;
// Differences reach four steps to either side; a 16th of a cycle is as far as they are to look.
constexpr int kCoarsestHalving = 6;
// Going coarser, the search ends where truncation has clearly taken over.
constexpr double kClearlyWorse = 100.0;

ExpressionEvaluator make_evaluator(const Expression& expression) {
  return {expression.text, expression.constants, {"t"}};
}

// How well differences with one step do over the cycle.
struct StepQuality {
  double step = 0.0;
  double truncation = 0.0;  // of the second derivative
  double rounding = 0.0;
  double scale = 0.0;  // size of the second derivative, not less than the motion over the cycle time squared

  [[nodiscard]] double error() const { return truncation + rounding; }
};

// On the grid of all multiples of the step, so that no kink of the cycle is passed over.
StepQuality judge_step(ExpressionEvaluator& evaluator, double cycle_time, int halvings) {
  const double h = std::ldexp(cycle_time, -halvings);
  std::vector<double> values((std::size_t{1} << halvings) + 2 * kReach + 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = (static_cast<double>(i) - kReach) * h;
    values[i] = evaluator.eval(&t);
  }
  StepQuality quality;
  double largest = 0.0;
  double uncertain = 0.0;
  double fastest = 0.0;
  double most_curved = 0.0;
  double apart_8_6 = 0.0;
  double apart_6_4 = 0.0;
  for (std::size_t i = kReach; i + kReach < values.size() && !std::isnan(apart_8_6); ++i) {
    double rate = 0.0;
    double eighth = 0.0;
    double sixth = 0.0;
    double fourth = 0.0;
    for (std::size_t k = 0; k < kReach; ++k) {
      const double sum = (values[i + k + 1] - values[i]) + (values[i - k - 1] - values[i]);
      rate += kFirst8[k] * (values[i + k + 1] - values[i - k - 1]);
      eighth += kSecond8[k] * sum;
      sixth += kSecond6[k] * sum;
      fourth += kSecond4[k] * sum;
    }
    // Written so that NaN stays.
    const double apart = std::abs(eighth - sixth);
    if (!(apart <= apart_8_6)) apart_8_6 = apart;
    apart_6_4 = std::max(apart_6_4, std::abs(sixth - fourth));
    const double argument = std::abs(static_cast<double>(i) - kReach);
    uncertain = std::max(uncertain, std::abs(values[i]) + argument * std::abs(rate));
    largest = std::max(largest, std::abs(values[i]));
    fastest = std::max(fastest, std::abs(rate));
    most_curved = std::max(most_curved, std::abs(eighth));
  }
  quality.step = h;
  // What the eighth order lacks is to the sixth's error as that is to the fourth's.
  quality.truncation = apart_8_6 / (h * h) * (apart_8_6 < apart_6_4 ? apart_8_6 / apart_6_4 : 1.0);
  quality.rounding = kRounding * std::numeric_limits<double>::epsilon() * uncertain / (h * h);
  quality.scale = most_curved / (h * h) + fastest / (h * cycle_time) + largest / (cycle_time * cycle_time);
  return quality;
}

StepQuality choose_step(ExpressionEvaluator& evaluator, double cycle_time) {
  StepQuality best = judge_step(evaluator, cycle_time, kFirstHalving);
  if (best.truncation > best.rounding) {
    for (int halvings = kFirstHalving + 1; halvings <= kFinestHalving; ++halvings) {
      const StepQuality finer = judge_step(evaluator, cycle_time, halvings);
      if (!(finer.error() < best.error())) break;
      best = finer;
    }
    // Where noise of the expression looks like truncation, coarser steps are better.
    if (best.step != std::ldexp(cycle_time, -kFirstHalving)) return best;
  }
  for (int halvings = kFirstHalving - 1; halvings >= kCoarsestHalving; --halvings) {
    const StepQuality coarser = judge_step(evaluator, cycle_time, halvings);
    if (!(coarser.error() <= kClearlyWorse * best.error())) break;
    if (coarser.error() < best.error()) best = coarser;
  }
  return best;
}

// Empty when differences with the step are good enough.
std::string find_roughness(const StepQuality& quality, double cycle_time) {
  if (quality.error() <= kLeastSmoothness * quality.scale) return {};
  if (std::isnan(quality.error())) {
    return fmt::format("has no value at some time between t = 0 and {:.4g} s, or just before or after", cycle_time);
  }
  return fmt::format("is not smooth: between t = 0 and {:.4g} s its acceleration is uncertain by {:.1g} of its size",
                     cycle_time, quality.error() / quality.scale);
}

void add_error(Diagnostics& diagnostics, const Driver& driver, const std::string& reason,
               std::vector<std::string> next) {
  diagnostics.error("E-MODEL-062", "drivers." + driver.name + ".motion",
                    fmt::format("driver '{}': {}", driver.name, reason), std::move(next));
}

}  // namespace

MotionFunction::MotionFunction(const DrivenMotion& motion)
    : start_(motion.start), speed_(motion.speed), difference_step_(motion.difference_step) {
  if (const auto* expression = std::get_if<Expression>(&motion.motion)) {
    function_.emplace<ExpressionEvaluator>(make_evaluator(*expression));
  } else if (const auto* curve = std::get_if<SampledCurve>(&motion.motion)) {
    function_.emplace<Curve>(make_motion_curve(*curve));
  }
}

DrivenValue MotionFunction::eval(double t) noexcept {
  DrivenValue at{start_ + speed_ * t, speed_, 0.0};
  if (const auto* curve = std::get_if<Curve>(&function_)) {
    const Curve::Value found = curve->eval(t);
    return {at.value + found.value, at.rate + found.slope, found.curvature};
  }
  auto* evaluator = std::get_if<ExpressionEvaluator>(&function_);
  if (evaluator == nullptr) return at;
  const double middle = evaluator->eval(&t);
  double first = 0.0;
  double second = 0.0;
  for (int k = 0; k < kReach; ++k) {
    const double later = t + (k + 1) * difference_step_;
    const double earlier = t - (k + 1) * difference_step_;
    const double ahead = evaluator->eval(&later);
    const double behind = evaluator->eval(&earlier);
    first += kFirst8[k] * (ahead - behind);
    second += kSecond8[k] * ((ahead - middle) + (behind - middle));
  }
  const double per_step = 1.0 / difference_step_;
  return {at.value + middle, at.rate + first * per_step, second * per_step * per_step};
}

void choose_difference_steps(const Mechanism& mechanism, std::vector<DrivenMotion>& motions) {
  const double cycle_time = find_cycle_time(mechanism, Study{});
  Diagnostics diagnostics;
  for (DrivenMotion& motion : motions) {
    const auto* expression = std::get_if<Expression>(&motion.motion);
    if (expression == nullptr) continue;
    const Driver& driver = mechanism.drivers[motion.driver];
    try {
      ExpressionEvaluator evaluator = make_evaluator(*expression);
      const StepQuality quality = choose_step(evaluator, cycle_time);
      motion.difference_step = quality.step;
      const std::string roughness = find_roughness(quality, cycle_time);
      if (roughness.empty()) continue;
      add_error(diagnostics, driver, fmt::format("its motion '{}' {}", expression->text, roughness),
                {"accelerations must be continuous: take out jumps and kinks, or give the motion as a table"});
    } catch (const ExpressionError& error) {
      add_error(diagnostics, driver, fmt::format("its motion '{}': {}", expression->text, error.what()),
                {"correct the expression; it may use the time t"});
    }
  }
  if (diagnostics.has_errors()) throw ModelError(diagnostics);
}

}  // namespace gudgeon
