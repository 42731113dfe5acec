// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// When, within a step, an argument leaves its piece.
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

#include "gudgeon/sim/load_breaks.h"

namespace gudgeon {

namespace {

constexpr int kCrossingBits = 45;
constexpr int kPeakBits = 24;  // a peak is flat: half of a double's digits are all there are
// A parabola through three looks may miss the argument's peak by this share of how far they are apart.
constexpr double kPeakMargin = 0.1;
// Halvings of the first part of a step that look for where an argument came in from a hair outside.
constexpr int kMostHalvings = 40;
// The rate at which an argument leaves is taken over this share of the step to either side.
constexpr double kRateShare = 1e-3;

}  // namespace

// Out of its piece is positive. What the evaluation did not come by cannot leave anything.
double LoadBreaks::find_excess(std::size_t k) const noexcept {
  const double x = arguments_[k];
  if (std::isnan(x)) return -std::numeric_limits<double>::infinity();
  return std::max(watched_[k].low - x, x - watched_[k].high);
}

bool LoadBreaks::is_inside(double t, const std::vector<double>& y, MotionEquations& equations) noexcept {
  measure(t, y.data(), equations);
  for (std::size_t k = 0; k < watched_.size(); ++k) {
    if (find_excess(k) > 0.0) return false;
  }
  return true;
}

void LoadBreaks::look(double share, const DenseStep& step, MotionEquations& equations) noexcept {
  step.interpolate(share, equations.n_states(), state_.data());
  measure(step.start_time() + share * step.step(), state_.data(), equations);
}

double LoadBreaks::look_at(std::size_t k, double share, const DenseStep& step, MotionEquations& equations) noexcept {
  look(share, step, equations);
  return find_excess(k);
}

double LoadBreaks::refine(std::size_t k, double inside, double outside, const DenseStep& step,
                          MotionEquations& equations) {
  const auto excess = [&](double share) { return std::clamp(look_at(k, share, step, equations), -1e300, 1e300); };
  const double a = excess(inside);
  const double b = excess(outside);
  if (!(a < 0.0 && b > 0.0)) return b > 0.0 ? inside : outside;
  std::uintmax_t most = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, inside, outside, a, b, boost::math::tools::eps_tolerance<double>(kCrossingBits), most);
  return 0.5 * (bracket.first + bracket.second);
}

// Where an argument that is inside at all three looks around the part's end has left its piece between them.
std::optional<double> LoadBreaks::find_peak(std::size_t k, int part, const DenseStep& step,
                                            MotionEquations& equations) {
  const std::size_t n = watched_.size();
  const double a = excess_[static_cast<std::size_t>(part - 1) * n + k];
  const double b = excess_[static_cast<std::size_t>(part) * n + k];
  const double c = excess_[static_cast<std::size_t>(part + 1) * n + k];
  const double bend = a - 2.0 * b + c;
  if (!(bend < 0.0)) return std::nullopt;
  const double at = 0.5 * (a - c) / bend;  // of the parabola's peak, in parts from the middle look
  if (std::abs(at) > 1.0) return std::nullopt;
  const double peak = b - 0.25 * (a - c) * at;
  if (peak < -kPeakMargin * (std::max({a, b, c}) - std::min({a, b, c}))) return std::nullopt;
  const double from = static_cast<double>(part - 1) / kParts;
  const double to = static_cast<double>(part + 1) / kParts;
  const auto [share, least] = boost::math::tools::brent_find_minima(
      [&](double s) { return -look_at(k, s, step, equations); }, from, to, kPeakBits);
  if (!(least < 0.0)) return std::nullopt;
  return refine(k, from, share, step, equations);
}

std::optional<double> LoadBreaks::find_crossing(std::size_t k, double limit, const DenseStep& step,
                                                MotionEquations& equations) {
  const std::size_t n = watched_.size();
  for (int part = 1; part <= kParts; ++part) {
    const double before = static_cast<double>(part - 1) / kParts;
    const double after = static_cast<double>(part) / kParts;
    if (before >= limit) return std::nullopt;
    const bool is_out = excess_[static_cast<std::size_t>(part) * n + k] > 0.0;
    if (!is_out) {
      if (part < kParts) {
        if (const auto peak = find_peak(k, part, step, equations)) return peak;
      }
      continue;
    }
    if (excess_[static_cast<std::size_t>(part - 1) * n + k] < 0.0) return refine(k, before, after, step, equations);
    // It starts a hair outside: does it come in first?
    double share = after;
    for (int halving = 0; halving < kMostHalvings; ++halving) {
      share = before + 0.5 * (share - before);
      if (look_at(k, share, step, equations) < 0.0) return refine(k, share, after, step, equations);
    }
    return before;
  }
  return std::nullopt;
}

std::optional<LoadBreaks::Leave> LoadBreaks::find_first_leave(const DenseStep& step, MotionEquations& equations) {
  if (!is_searched_) return std::nullopt;
  const std::size_t n = watched_.size();
  for (int part = 0; part <= kParts; ++part) {
    look(static_cast<double>(part) / kParts, step, equations);
    for (std::size_t k = 0; k < n; ++k) excess_[static_cast<std::size_t>(part) * n + k] = find_excess(k);
  }
  std::optional<Leave> first;
  for (std::size_t k = 0; k < n; ++k) {
    const auto share = find_crossing(k, first ? first->share : 1.0, step, equations);
    if (share && (!first || *share < first->share)) first = Leave{k, *share, 0.0};
  }
  if (!first) return std::nullopt;
  last_left_ = first->watched;
  const double from = std::max(0.0, first->share - kRateShare);
  const double to = std::min(1.0, first->share + kRateShare);
  const double rise = look_at(first->watched, to, step, equations) - look_at(first->watched, from, step, equations);
  first->rate = rise / ((to - from) * step.step());
  return first;
}

}  // namespace gudgeon
