// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Jumps of a motion, its speed or its acceleration, sought over the whole study where the formula's pieces meet.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "gudgeon/base/expression.h"
#include "gudgeon/model/check_rules.h"
#include "gudgeon/model/cycle_time.h"

namespace gudgeon {

namespace {

// Moments of each cycle, and of a study in all, at which the pieces are looked at.
constexpr double kTrialsACycle = 4096;
constexpr double kMostTrials = 1 << 18;
// Changes of one break that are looked into; what does not jump at so many is taken not to jump.
constexpr int kMostChanges = 1000;
// Step of one-sided differences, as a share of the cycle.
constexpr double kDifferenceStep = 1e-4;
// What counts as a jump of value, speed and acceleration, in units of range, range/cycle and range/cycle².
constexpr std::array kLeastJumps{1e-9, 1e-6, 1e-3};
// One-sided differences of fourth and third order, of value, slope and curvature at the first of five points.
constexpr std::array<std::array<double, 5>, 3> kOneSided{{{1.0, 0.0, 0.0, 0.0, 0.0},
                                                          {-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25},
                                                          {35.0 / 12.0, -26.0 / 3.0, 9.5, -14.0 / 3.0, 11.0 / 12.0}}};
// A difference that half the step changes by more than this is one of the differences, not of the motion.
constexpr double kSameJump = 0.3;

class JumpSearch {
 public:
  JumpSearch(const Expression& expression, double cycle_time, double duration)
      : motion_(expression.text, expression.constants, {"t"}),
        states_(motion_.breaks().size()),
        cycle_time_(cycle_time),
        duration_(duration),
        n_trials_(static_cast<int>(std::clamp(kTrialsACycle * duration / cycle_time, kTrialsACycle, kMostTrials))) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int i = 0; i <= n_trials_; ++i) {
      const double value = eval(motion_, duration_ * i / n_trials_);
      low = std::fmin(low, value);
      high = std::fmax(high, value);
    }
    range_ = high - low;
    size_ = std::max(std::abs(low), std::abs(high));
  }

  /// The first jump of the first break that has one.
  std::optional<MotionJump> find() {
    if (!(range_ > 0.0)) return std::nullopt;
    for (std::size_t k = 0; k < motion_.breaks().size(); ++k) {
      if (motion_.breaks()[k].kind == BreakKind::smooth_step) continue;
      if (const auto jump = find(k)) return jump;
    }
    return std::nullopt;
  }

 private:
  static double eval(ExpressionEvaluator& formula, double t) { return formula.eval(&t); }

  /// Which piece of the break the motion is on; kFreePiece in a branch that is not taken.
  int find_piece(std::size_t index, double t) {
    static_cast<void>(motion_.eval(&t, nullptr, states_.data()));
    return states_[index].met ? states_[index].piece : kFreePiece;
  }

  std::optional<MotionJump> find(std::size_t index) {
    int before = find_piece(index, 0.0);
    int n_changes = 0;
    for (int i = 1; i <= n_trials_ && n_changes < kMostChanges; ++i) {
      double below = duration_ * (i - 1) / n_trials_;
      double above = duration_ * i / n_trials_;
      const int now = find_piece(index, above);
      if (now == before) continue;
      ++n_changes;
      while (true) {
        const double middle = 0.5 * (below + above);
        if (middle <= below || middle >= above) break;
        (find_piece(index, middle) == before ? below : above) = middle;
      }
      if (const auto jump = find(below, above)) return jump;
      before = now;
    }
    return std::nullopt;
  }

  std::optional<MotionJump> find(double below, double above) {
    double unit = range_;
    for (int order = 0; order <= 2; ++order, unit /= cycle_time_) {
      const double step = kDifferenceStep * cycle_time_;
      const double whole = find_jump(order, below, above, step);
      const double half = find_jump(order, below, above, 0.5 * step);
      // What rounding of the values leaves in the difference with half the step.
      const double rounding = 50.0 * std::numeric_limits<double>::epsilon() * size_ / std::pow(0.5 * step, order);
      if (std::abs(whole) <= kLeastJumps[order] * unit + rounding) continue;
      if (std::abs(half - whole) <= kSameJump * std::abs(whole)) return MotionJump{above, order, half};
    }
    return std::nullopt;
  }

  // Of the value, slope or curvature from one side to the other.
  double find_jump(int order, double below, double above, double step) {
    double left = 0.0;
    double right = 0.0;
    for (int k = 0; k < 5; ++k) {
      right += kOneSided[order][k] * eval(motion_, above + k * step);
      left += kOneSided[order][k] * eval(motion_, below - k * step);
    }
    const double scale = std::pow(step, order);
    return (right - (order == 1 ? -left : left)) / scale;
  }

  ExpressionEvaluator motion_;
  std::vector<BreakState> states_;
  double cycle_time_;
  double duration_;
  int n_trials_;
  double range_ = 0.0;
  double size_ = 0.0;
};

}  // namespace

std::optional<MotionJump> find_motion_jump(const Expression& motion, double cycle_time, double duration) {
  if (!(duration > 0.0) || !std::isfinite(duration) || !(cycle_time > 0.0)) return std::nullopt;
  return JumpSearch(motion, cycle_time, duration).find();
}

}  // namespace gudgeon
