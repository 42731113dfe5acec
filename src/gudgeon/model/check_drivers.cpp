// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for drivers: what they drive, and their motions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "gudgeon/base/curve.h"
#include "gudgeon/base/expression.h"
#include "gudgeon/model/check_rules.h"
#include "gudgeon/model/cycle_time.h"

namespace gudgeon {

namespace {

// Start angles that differ by less are the same number written twice.
constexpr double kSameAngle = 1e-9;
// So do displacements, in shares of themselves.
constexpr double kSameDisplacement = 1e-9;
// A table that falls short of the run by less, of its duration, ends with it.
constexpr double kSameDuration = 1e-9;
// How many moments of the run a motion is tried at: a gap of a thousandth of the run is found.
constexpr int kTrials = 1000;

class DriverCheck {
 public:
  DriverCheck(CheckRules& rules, const Driver& driver)
      : rules_(rules),
        driver_(driver),
        subject_(fmt::format("driver '{}'", driver.name)),
        path_(fmt::format("drivers.{}", driver.name)) {}

  /// What is driven, in words that are the same for the same target; empty when it does not exist.
  std::string check_target() {
    if (const auto* slide = std::get_if<DrivenSlide>(&driver_.target)) {
      return check_slide(slide->joint) ? fmt::format("joint '{}'", slide->joint) : std::string{};
    }
    const auto& angle = std::get<DrivenAngle>(driver_.target);
    const bool body = check_body(".body", angle.body);
    const bool against = check_body(".against", angle.against);
    if (!body || !against) return {};
    if (angle.body == angle.against && angle.body != kFrameName) {
      rules_.diagnostics.error("E-MODEL-044", path_ + ".against",
                               fmt::format("{} drives body '{}' against itself", subject_, angle.body));
      return {};
    }
    if (angle.body == kFrameName) {
      std::vector<std::string> notes;
      if (angle.against != kFrameName) notes.push_back(fmt::format("drive body '{}' instead", angle.against));
      rules_.diagnostics.error("E-MODEL-041", path_ + ".body",
                               fmt::format("{} drives the frame, which does not move", subject_), notes);
      return {};
    }
    if (angle.against == kFrameName) return fmt::format("body '{}'", angle.body);
    const auto [low, high] = std::minmax(angle.body, angle.against);
    return fmt::format("the angle between bodies '{}' and '{}'", low, high);
  }

  void check_motion() {
    const bool turns = std::holds_alternative<DrivenAngle>(driver_.target);
    const FunctionUse use{subject_ + ": motion", path_, "motion", turns ? dimension::kAngle : dimension::kLength, true};
    if (const auto* expression = std::get_if<Expression>(&driver_.motion)) {
      if (check_expression(rules_, use, *expression) && check_values(*expression))
        check_jumps(*expression, use.dimension);
    } else if (const auto* curve = std::get_if<SampledCurve>(&driver_.motion)) {
      if (check_curve(rules_, use, *curve)) check_cover(*curve);
    } else {
      const Dimension start = turns ? dimension::kAngle : dimension::kLength;
      const Dimension speed = turns ? dimension::kAngularSpeed : dimension::kSpeed;
      rules_.check_range("E-MODEL-005", {subject_, path_ + ".start", driver_.start, start}, {});
      rules_.check_range("E-MODEL-005", {subject_, path_ + ".speed", driver_.speed, speed}, {});
      start_ = driver_.start;
    }
  }

  void remark_start() {
    if (const auto* slide = std::get_if<DrivenSlide>(&driver_.target)) remark_start_displacement(*slide);
    const auto* angle = std::get_if<DrivenAngle>(&driver_.target);
    if (angle == nullptr || !start_) return;
    const auto guess = find_guess(angle->body);
    const auto against = find_guess(angle->against);
    if (!guess || !against || !(std::abs(*guess - *against - *start_) > kSameAngle)) return;
    const bool relative = angle->against != kFrameName;
    rules_.diagnostics.remark(
        "R-MODEL-107", path_ + (driver_.is_uniform() ? ".start" : ".motion"),
        fmt::format("{} starts at {:.6g} rad, body '{}'{} at {:.6g} rad; the driver's holds", subject_, *start_,
                    angle->body, relative ? fmt::format(" against '{}'", angle->against) : "", *guess - *against));
  }

 private:
  void remark_start_displacement(const DrivenSlide& slide) {
    const auto* guide = std::get_if<Prismatic>(&rules_.mechanism.joints[rules_.names.find_joint(slide.joint)].kind);
    if (guide == nullptr || !guide->start.displacement || !start_) return;
    const double given = *guide->start.displacement;
    if (!(std::abs(given - *start_) > kSameDisplacement * std::max(std::abs(given), std::abs(*start_)))) return;
    rules_.diagnostics.remark("R-MODEL-107", path_ + (driver_.is_uniform() ? ".start" : ".motion"),
                              fmt::format("{} starts at {:.6g} mm, joint '{}' at {:.6g} mm; the driver's holds",
                                          subject_, 1e3 * *start_, slide.joint, 1e3 * given));
  }

  bool check_body(const char* key, const std::string& body) {
    if (rules_.names.find_body(body) >= 0) return true;
    rules_.report_unknown("E-MODEL-040", path_ + key,
                          fmt::format("{} drives {}unknown body '{}'", subject_,
                                      std::string_view{key} == ".against" ? "against " : "", body),
                          body, "bodies", list_names(rules_.mechanism.bodies));
    return false;
  }

  bool check_slide(const std::string& joint) {
    const int index = rules_.names.find_joint(joint);
    if (index < 0) {
      rules_.report_unknown("E-MODEL-040", path_ + ".slide",
                            fmt::format("{} drives unknown joint '{}'", subject_, joint), joint, "joints",
                            list_names(rules_.mechanism.joints));
      return false;
    }
    const AnyJoint& kind = rules_.mechanism.joints[index].kind;
    if (std::holds_alternative<Prismatic>(kind)) return true;
    std::vector<std::string> notes;
    if (has_clearance(kind))
      notes.emplace_back("a joint with clearance cannot be driven: nothing prescribes its motion");
    rules_.diagnostics.error("E-MODEL-043", path_ + ".slide",
                             fmt::format("{} drives joint '{}', which is not prismatic", subject_, joint), notes);
    return false;
  }

  /// [s] How long a stage runs; 0 while the study is not sound.
  [[nodiscard]] double find_duration() const {
    const Study& study = rules_.study;
    const double duration = find_cycle_time(rules_.mechanism, study) * (study.cycles + study.warm_up_cycles);
    return std::isfinite(duration) && study.cycles > 0 && study.warm_up_cycles >= 0 ? std::max(duration, 0.0) : 0.0;
  }

  /// True when it has a value throughout.
  bool check_values(const Expression& expression) {
    ExpressionEvaluator motion(expression.text, expression.constants, {"t"});
    const double duration = find_duration();
    for (int k = 0; k <= kTrials; ++k) {
      const double time = duration * k / kTrials;
      const double value = motion.eval(&time);
      if (k == 0) start_ = value;
      if (std::isfinite(value)) continue;
      rules_.diagnostics.error(
          "E-MODEL-088", path_ + ".motion",
          fmt::format("{}: motion \"{}\" has no value at t = {:.6g} s", subject_, expression.text, time));
      return false;
    }
    return true;
  }

  /// Accelerations must go on without a jump, over the whole study.
  void check_jumps(const Expression& expression, Dimension dimension) {
    static constexpr std::array kWhat{"it", "its speed", "its acceleration"};
    const auto jump = find_motion_jump(expression, find_cycle_time(rules_.mechanism, rules_.study), find_duration());
    if (!jump) return;
    dimension.time = -jump->order;
    rules_.diagnostics.error(
        "E-MODEL-062", path_ + ".motion",
        fmt::format("{}: its motion '{}' is not smooth: {} jumps by {} at t = {:.6g} s", subject_, expression.text,
                    kWhat[jump->order], with_unit(jump->size, dimension), jump->time),
        {"accelerations must be continuous: smooth_step(t, a, b) goes from 0 to 1 so, or give the motion as a table"});
  }

  void check_cover(const SampledCurve& curve) {
    start_ = make_motion_curve(curve).eval(0.0).value;
    const double duration = find_duration();
    const double margin = kSameDuration * duration;
    if (curve.periodic || (curve.arguments.front() <= margin && curve.arguments.back() >= duration - margin)) return;
    rules_.diagnostics.error(
        "E-MODEL-087", path_ + ".motion.arguments",
        fmt::format("{}: motion is known from {:.6g} s to {:.6g} s, and the study runs from 0 s to {:.6g} s", subject_,
                    curve.arguments.front(), curve.arguments.back(), duration),
        {"add points, shorten the study, or let it repeat with periodic = true"});
  }

  [[nodiscard]] std::optional<double> find_guess(const std::string& body) const {
    if (body == kFrameName) return 0.0;
    const int index = rules_.names.find_body(body);
    return index < 0 ? std::nullopt : rules_.mechanism.bodies[index].start.angle;
  }

  CheckRules& rules_;
  const Driver& driver_;
  std::string subject_;
  std::string path_;
  std::optional<double> start_;  // [rad or m] at t = 0
};

}  // namespace

void check_drivers(CheckRules& rules) {
  std::map<std::string, int> seen;
  for (const Driver& driver : rules.mechanism.drivers) {
    DriverCheck check(rules, driver);
    const std::string target = check.check_target();
    if (!target.empty() && ++seen[target] > 1) {
      rules.diagnostics.error("E-MODEL-042", fmt::format("drivers.{}", driver.name),
                              fmt::format("{} has more than one driver", target));
    }
    check.check_motion();
    if (!target.empty()) check.remark_start();
  }
}

}  // namespace gudgeon
