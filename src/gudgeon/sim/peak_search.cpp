// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Successive parabolas.
#include "gudgeon/sim/peak_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace gudgeon {

namespace {

// A new extreme is worth a measurement from this share of the signal's own size on.
constexpr double kWorthwhile = 2e-5;
// A parabola through points that are far apart may miss so much of what is to be gained.
constexpr double kDoubt = 2.0;

// The vertex of the parabola through three points, as a time after the middle one and a gain over it.
struct Vertex {
  double after;
  double gain;
};

Vertex find_vertex(double before, double after, double difference_before, double difference_after) {
  const double slope_before = difference_before / before;
  const double slope_after = difference_after / after;
  const double bend = (slope_after - slope_before) / (before + after);
  const double slope = (slope_before * after + slope_after * before) / (before + after);
  return {-0.5 * slope / bend, -0.25 * slope * slope / bend};
}

}  // namespace

PeakSearch::PeakSearch(std::size_t n_signals, Measure measure)
    : n_signals_(n_signals),
      measure_(std::move(measure)),
      rows_(kRows * n_signals),
      greatest_(n_signals, -std::numeric_limits<double>::infinity()),
      least_(n_signals, std::numeric_limits<double>::infinity()),
      taken_{{{0.0, 0}, {0.0, 1}}} {}

void PeakSearch::forget(std::size_t signal) {
  greatest_[signal] = least_[signal] = rows_[taken_.back().row * n_signals_ + signal];
}

void PeakSearch::note_extremes(std::span<const double> row) noexcept {
  for (std::size_t k = 0; k < n_signals_; ++k) {
    greatest_[k] = row[k] > greatest_[k] ? row[k] : greatest_[k];
    least_[k] = row[k] < least_[k] ? row[k] : least_[k];
  }
}

void PeakSearch::take(double time) {
  const Point now{time, newest_};
  note_extremes(row_of(now.row));
  if (n_taken_ == kTaken - 1) {
    points_[0] = taken_[0];
    points_[1] = taken_[1];
    points_[2] = now;
    n_points_ = kTaken;
    search();
  }
  n_taken_ = std::min(n_taken_ + 1, kTaken - 1);
  newest_ = taken_[0].row;
  taken_ = {taken_[1], now};
}

void PeakSearch::look_between(double time, std::size_t signal) {
  points_[0] = taken_[0];
  points_[1] = taken_[1];
  n_points_ = 2;
  look(time, 1);
  refine(signal, 1.0);
}

void PeakSearch::search() {
  const double* a = rows_.data() + points_[0].row * n_signals_;
  const double* b = rows_.data() + points_[1].row * n_signals_;
  const double* c = rows_.data() + points_[2].row * n_signals_;
  // The parabola's vertex is above its highest point by a quarter of one of the two differences to it, times how long
  // the other takes beside it, at most.
  const double before = points_[1].time - points_[0].time;
  const double after = points_[2].time - points_[1].time;
  const double reach_after = 0.25 * kDoubt * after / before;
  const double reach_before = 0.25 * kDoubt * before / after;
  const double* greatest = greatest_.data();
  const double* least = least_.data();
  // Whether there may be one at all is found without branches, several signals at once.
  std::int64_t any = 0;
  for (std::size_t k = 0; k < n_signals_; ++k) {
    const double rise = b[k] - a[k];
    const double fall = b[k] - c[k];
    const double gain_after = std::abs(rise) * reach_after;
    const double gain_before = std::abs(fall) * reach_before;
    const double gain = gain_after > gain_before ? gain_after : gain_before;
    const auto is_over = static_cast<std::int64_t>(b[k] + gain > greatest[k]);
    const auto is_under = static_cast<std::int64_t>(b[k] - gain < least[k]);
    any |= static_cast<std::int64_t>(rise * fall > 0.0) & (is_over | is_under);
  }
  if (any == 0) return;
  for (std::size_t k = 0; k < n_signals_; ++k) {
    const double rise = b[k] - a[k];
    const double fall = b[k] - c[k];
    if (!(rise * fall > 0.0)) continue;
    const double reach =
        b[k] + std::copysign(std::max(std::abs(rise) * reach_after, std::abs(fall) * reach_before), rise);
    if (reach > greatest[k] || reach < least[k]) refine(k, rise > 0.0 ? 1.0 : -1.0);
  }
}

// Looks for a greatest value of the signal, or for a least one.
void PeakSearch::refine(std::size_t signal, double sign) {
  while (n_points_ < kMostPoints) {
    std::size_t best = 1;
    for (std::size_t p = 2; p + 1 < n_points_; ++p) {
      if (sign * value(p, signal) > sign * value(best, signal)) best = p;
    }
    const Point& at = points_[best];
    const double peak = value(best, signal);
    const double rise = peak - value(best - 1, signal);
    const double fall = value(best + 1, signal) - peak;
    if (sign * rise < 0.0 || sign * fall > 0.0) return;
    const Vertex vertex = find_vertex(at.time - points_[best - 1].time, points_[best + 1].time - at.time, rise, fall);
    const double record = sign > 0.0 ? greatest_[signal] : -least_[signal];
    const double size = std::max(std::abs(greatest_[signal]), std::abs(least_[signal]));
    // Neither where nothing bends, nor where a value is none.
    if (!(sign * peak + kDoubt * sign * vertex.gain > record + kWorthwhile * size)) return;
    if (!(sign * vertex.gain < std::numeric_limits<double>::infinity())) return;
    const double time = at.time + vertex.after;
    look(time, vertex.after > 0.0 ? best + 1 : best);
  }
}

// Measures at a time, whose place among the points is known.
void PeakSearch::look(double time, std::size_t place) {
  const Point point{time, n_points_ + 1};
  measure_(time, row_of(point.row));
  note_extremes(row_of(point.row));
  std::copy_backward(points_.begin() + static_cast<std::ptrdiff_t>(place),
                     points_.begin() + static_cast<std::ptrdiff_t>(n_points_),
                     points_.begin() + static_cast<std::ptrdiff_t>(n_points_) + 1);
  points_[place] = point;
  ++n_points_;
}

}  // namespace gudgeon
