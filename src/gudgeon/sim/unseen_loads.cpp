// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where steep parts turn or pass zero, and whether that shows.
#include "gudgeon/sim/unseen_loads.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

#include "gudgeon/base/steep_parts.h"
#include "gudgeon/system/load_forces.h"

namespace gudgeon {

namespace {

// A load that is off the cubic through four looks by this share of its largest value has not been seen: forces that a
// step resolves are met a hundred times closer.
constexpr double kUnseen = 1e-3;
// What is less than this share of the largest that was ever looked at does not matter any more.
constexpr double kFaint = 1e-6;
// Parts that move by less than this share of their size are at rest but for rounding.
constexpr double kRestShare = 1e-9;
constexpr int kPlaceBits = 40;
constexpr int kPeakBits = 26;  // a peak is flat: half of a double's digits are all there are
// Of the step: what is so near its ends is seen by them.
constexpr double kAtEnds = 1e-6;
// Beside a place, as where a load has two lobes or a flank: shares of the step, each a quarter of the last.
constexpr double kFirstBeside = 0.0625;
constexpr int kBeside = 12;

bool is_speed(StateChannel::Quantity quantity) {
  using enum StateChannel::Quantity;
  return quantity == x_velocity || quantity == y_velocity || quantity == angle_rate || quantity == speed;
}

}  // namespace

UnseenLoads::UnseenLoads(const System& system)
    : system_(&system),
      scratch_(system.tables),
      state_(2 * static_cast<std::size_t>(system.tables.counts.n_free()) +
             static_cast<std::size_t>(system.tables.n_bristles)) {
  const LoadTables& loads = system.tables.loads;
  for (std::size_t e = 0; e < loads.expressions.size(); ++e) {
    const Expression& given = loads.expressions[e];
    std::vector<ExpressionEvaluator> parts;
    for (const std::string& part : list_steep_parts(given.text)) {
      ExpressionEvaluator evaluator(part, given.constants, loads.channel_names);
      const std::vector<int>& used = evaluator.used_variables();
      const bool has_speed = std::ranges::any_of(
          used, [&](int channel) { return is_speed(loads.channels[static_cast<std::size_t>(channel)].quantity); });
      if (!used.empty() && !has_speed) parts.push_back(std::move(evaluator));
    }
    if (parts.empty()) continue;
    ExpressionEvaluator whole(given.text, given.constants, loads.channel_names);
    std::vector<std::array<double, kLooks>> looks(parts.size());
    std::vector<BreakState> breaks(whole.breaks().size());
    formulas_.push_back({e, std::move(whole), std::move(parts), std::move(looks), std::move(breaks)});
  }
  for (std::vector<double>& channels : channels_) channels.assign(loads.channels.size(), 0.0);
}

// The channels at a place within the step.
double* UnseenLoads::look(double share, const DenseStep& step, MotionEquations& equations) noexcept {
  const double t = step.start_time() + share * step.step();
  step.interpolate(share, state_.size(), state_.data());
  update_coordinates(system_->tables, t, state_.data(), state_.data() + equations.n_free(), scratch_.coordinates);
  update_point_motions(system_->tables, scratch_);
  update_load_channels(system_->tables, t, scratch_);
  return scratch_.loads.channel_values.data();
}

double UnseenLoads::eval_whole(Formula& formula, const double* channels, const MotionEquations& equations) noexcept {
  const LoadScratch& loads = equations.workspace.loads;
  const int* held = loads.held.pieces.data() + loads.first_break[formula.expression];
  return formula.whole.eval(channels, formula.breaks.empty() ? nullptr : held, formula.breaks.data());
}

std::optional<double> UnseenLoads::find(const DenseStep& step, MotionEquations& equations) {
  for (int k = 0; k < kLooks; ++k) {
    std::copy_n(look(static_cast<double>(k) / kParts, step, equations), channels_[k].size(), channels_[k].begin());
  }
  std::optional<double> first;
  for (Formula& formula : formulas_) {
    if (equations.workspace.loads.held.slides[formula.expression] >= 0) continue;
    const std::optional<double> share = find_in(formula, step, equations);
    if (share && (!first || *share < *first)) first = share;
  }
  if (!first) return std::nullopt;
  return step.start_time() + *first * step.step();
}

std::optional<double> UnseenLoads::find_in(Formula& formula, const DenseStep& step, MotionEquations& equations) {
  is_looked_ = false;
  for (std::size_t p = 0; p < formula.parts.size(); ++p) {
    ExpressionEvaluator& part = formula.parts[p];
    std::array<double, kLooks>& value = formula.looks[p];
    for (int k = 0; k < kLooks; ++k) value[k] = part.eval(channels_[k].data());
    const auto [least, most] = std::ranges::minmax(value);
    if (!(most - least > kRestShare * std::max(std::abs(least), std::abs(most)))) continue;
    const auto eval = [&](double share) { return part.eval(look(share, step, equations)); };
    for (int k = 0; k + 1 < kLooks; ++k) {
      const double from = static_cast<double>(k) / kParts;
      if (value[k] * value[k + 1] < 0.0) {
        std::uintmax_t tries = 50;
        const auto bracket =
            boost::math::tools::toms748_solve(eval, from, from + 1.0 / kParts, value[k], value[k + 1],
                                              boost::math::tools::eps_tolerance<double>(kPlaceBits), tries);
        if (const auto found = judge(formula, 0.5 * (bracket.first + bracket.second), step, equations)) return found;
      }
      if (k == 0) continue;
      const double bend = value[k - 1] - 2.0 * value[k] + value[k + 1];
      const double turn = 0.5 * (value[k - 1] - value[k + 1]) / bend;  // in parts from the middle look
      if (!(std::abs(turn) <= 1.0)) continue;
      const double sign = bend < 0.0 ? -1.0 : 1.0;
      const double share = boost::math::tools::brent_find_minima([&](double s) { return sign * eval(s); },
                                                                 from - 1.0 / kParts, from + 1.0 / kParts, kPeakBits)
                               .first;
      if (const auto found = judge(formula, share, step, equations)) return found;
    }
  }
  return std::nullopt;
}

// Whether the formula is quite other at that share of the step, or beside it, than the looks say: where.
std::optional<double> UnseenLoads::judge(Formula& formula, double share, const DenseStep& step,
                                         MotionEquations& equations) {
  if (share < kAtEnds || share > 1.0 - kAtEnds) return std::nullopt;
  look_around(formula, equations);
  const auto find_surprise = [&](double at) {
    const double value = eval_whole(formula, look(at, step, equations), equations);
    const double scale = std::max(scale_, std::abs(value));
    const double surprise = std::abs(value - expect(at));
    if (std::isnan(surprise)) return std::isnan(value) && std::isfinite(scale_) ? scale : 0.0;
    return surprise > kUnseen * scale ? surprise : 0.0;
  };
  if (find_surprise(share) > 0.0) return share;
  double largest = 0.0;
  double place = share;
  double beside = kFirstBeside;
  for (int k = 0; k < kBeside; ++k, beside *= 0.25) {
    for (const double at : {share - beside, share + beside}) {
      if (at < kAtEnds || at > 1.0 - kAtEnds) continue;
      const double surprise = find_surprise(at);
      if (surprise > largest) largest = surprise, place = at;
    }
  }
  if (largest == 0.0) return std::nullopt;
  return place;
}

void UnseenLoads::look_around(Formula& formula, MotionEquations& equations) noexcept {
  if (is_looked_) return;
  is_looked_ = true;
  scale_ = kFaint * formula.largest;
  for (int k = 0; k < kLooks; ++k) {
    around_[k] = eval_whole(formula, channels_[k].data(), equations);
    scale_ = std::max(scale_, std::abs(around_[k]));
  }
  formula.largest = std::max(formula.largest, scale_);
}

// By the cubic through the four looks around.
double UnseenLoads::expect(double share) const noexcept {
  const double x = share * kParts;
  const int first = std::clamp(static_cast<int>(x) - 1, 0, kParts - 3);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    double weight = 1.0;
    for (int j = 0; j < 4; ++j) {
      if (j != i) weight *= (x - first - j) / (i - j);
    }
    sum += weight * around_[first + i];
  }
  return sum;
}

}  // namespace gudgeon
