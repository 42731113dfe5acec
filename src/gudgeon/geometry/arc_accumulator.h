// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sums of many arcs distributed over a circumference of equal cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "gudgeon/base/state_archive.h"

namespace gudgeon {

/// Adds constant amounts over arcs, also over such as move and grow: only where an arc's ends are, or pass, are changes
/// noted, as first differences; sum() integrates them. Parabolas are added cell by cell. A cell that an arc
/// covers in part, or for part of its movement, gets that part, so that what is distributed in all equals mean amount
/// times arc width, to rounding, whatever the number of cells.
class ArcAccumulator {
 public:
  explicit ArcAccumulator(std::size_t n_cells)
      : differences_(n_cells + 2, 0.0),
        cell_amounts_(n_cells, 0.0),
        cells_per_radian_(static_cast<double>(n_cells) / (2.0 * std::numbers::pi)) {}

  /// What one end of a moving arc passes at an even speed, in cells from the seam on.
  struct Ramp {
    double from = 0.0;
    double to = 0.0;
  };
  struct Sweep {
    Ramp rear;
    Ramp front;
  };
  /// What one circumference of several gets.
  struct Increment {
    ArcAccumulator* surface;
    double amount;
  };

  /// From an arc of that width [rad] centred at `angle` [rad] to another centred `turn` [rad] farther, either way
  /// round; the same for all that have as many cells. Within one circumference: what is more is not moved. An end
  /// that passes less than a share `softness` of the mean width is spread over as much, about its middle.
  [[nodiscard]] Sweep find_sweep(double angle, double width, double turn, double end_width,
                                 double softness = 0.0) const noexcept {
    const double n = static_cast<double>(cell_amounts_.size());
    const double room = std::max(2.0 * std::numbers::pi - 0.5 * (1.0 + softness) * (width + end_width), 0.0);
    const double move = std::clamp(turn, -room, room) * cells_per_radian_;
    const double half = 0.5 * width * cells_per_radian_;
    const double end_half = 0.5 * end_width * cells_per_radian_;
    const double least = 0.5 * softness * (half + end_half);
    const double middle = angle * cells_per_radian_ + 0.5 * move;
    const double rear = middle - 0.5 * (half + end_half);
    const double front = middle + 0.5 * (half + end_half);
    const double rear_half = std::max(0.5 * std::abs(move + half - end_half), least);
    const double front_half = std::max(0.5 * std::abs(move + end_half - half), least);
    const double shift = n * std::floor((rear - rear_half) / n);
    return {{rear - rear_half - shift, rear + rear_half - shift},
            {front - front_half - shift, front + front_half - shift}};
  }

  /// Adds to every point the increment's amount times the share of the movement during which the arc covers it, on
  /// circumferences of as many cells.
  static void add_sweep(const Sweep& sweep, std::span<const Increment> increments) noexcept {
    const double rear = add_ramp(sweep.rear, 1.0, increments);
    const double front = add_ramp(sweep.front, -1.0, increments);
    for (const Increment& increment : increments) increment.surface->base_ += increment.amount * (rear - front);
  }

  /// The same on this circumference.
  void add_sweep(const Sweep& sweep, double amount) noexcept {
    const Increment increment{this, amount};
    add_sweep(sweep, {&increment, 1});
  }

  /// Adds `amount` to every point of the arc of that width [rad] <= 2π centred at `angle` [rad].
  void add_arc(double angle, double width, double amount) noexcept {
    add_sweep(find_sweep(angle, width, 0.0, width), amount);
  }

  /// Adds a parabola that vanishes at both ends of the arc, 3/2 mean_amount (1 − (2x/width)²) at x [rad] from its
  /// centre, or its mean over a movement by `turn` [rad]. Every cell gets the exact mean over it.
  void add_parabola(double angle, double width, double mean_amount, double turn = 0.0) noexcept {
    const std::size_t n = cell_amounts_.size();
    const double cells = width * cells_per_radian_;
    if (!(cells > 0.0)) return;
    const double path = std::abs(turn) / width;
    // A short movement is its middle, lest differences lose their digits: what that costs goes with its square.
    const bool moves = path > kLeastPath;
    double first = (angle + (moves ? std::min(turn, 0.0) : 0.5 * turn)) * cells_per_radian_ - 0.5 * cells;
    first -= static_cast<double>(n) * std::floor(first / static_cast<double>(n));
    const double all = mean_amount * cells;
    double before = 0.0;
    for (std::size_t k = static_cast<std::size_t>(first); before < 1.0; ++k) {
      const double share = (static_cast<double>(k + 1) - first) / cells;
      const double held = moves ? hold_moved(share, path) : hold(share);
      cell_amounts_[k % n] += all * (held - before);
      before = held;
    }
  }

  /// Adds `amount` to the one cell that holds the angle [rad].
  void add_point(double angle, double amount) noexcept {
    const double n = static_cast<double>(cell_amounts_.size());
    double position = angle * cells_per_radian_;
    position -= n * std::floor(position / n);
    const std::size_t cell = static_cast<std::size_t>(position);
    cell_amounts_[cell < cell_amounts_.size() ? cell : 0] += amount;
  }

  /// The mean amount over each cell.
  [[nodiscard]] std::vector<double> sum() const {
    std::vector<double> amounts = cell_amounts_;
    double level = base_;
    for (std::size_t k = 0; k < amounts.size(); ++k) {
      level += differences_[k];
      amounts[k] += level;
    }
    return amounts;
  }

  void transfer(StateArchive& archive) { archive(differences_, cell_amounts_, base_); }

 private:
  static constexpr double kLeastPath = 1e-3;  // widths

  // Raises all that lies behind a ramp by `sign` times each increment's amount. Returns the share of it that is reached
  // at the seam. What is noted are the differences of the ramp's mean over each cell; between its ends they are equal.
  static double add_ramp(const Ramp& ramp, double sign, std::span<const Increment> increments) noexcept {
    const std::size_t n = increments.front().surface->cell_amounts_.size();
    const std::size_t first = static_cast<std::size_t>(ramp.from);
    const std::size_t last = static_cast<std::size_t>(ramp.to);
    const double begin = static_cast<double>(first);
    const double end = static_cast<double>(last);
    const bool is_within_one = first == last;
    const double slope = is_within_one ? 0.0 : 1.0 / (ramp.to - ramp.from);
    const auto find_inner = [&](double cell) { return slope * (cell + 0.5 - ramp.from); };
    const double first_share = is_within_one ? begin + 1.0 - 0.5 * (ramp.from + ramp.to)
                                             : 0.5 * slope * (begin + 1.0 - ramp.from) * (begin + 1.0 - ramp.from);
    const double last_share = is_within_one ? first_share : 1.0 - 0.5 * slope * (ramp.to - end) * (ramp.to - end);
    for (const Increment& increment : increments) {
      double* differences = increment.surface->differences_.data();
      const double amount = sign * increment.amount;
      const auto wrap = [n](std::size_t cell) { return cell < n ? cell : cell - n; };
      differences[wrap(first)] += amount * first_share;
      if (last > first + 1) {
        differences[wrap(first + 1)] += amount * (find_inner(begin + 1.0) - first_share);
        const double step = amount * slope;
        for (std::size_t k = first + 2; k < std::min(last, n); ++k) differences[k] += step;
        for (std::size_t k = std::max(first + 2, n); k < last; ++k) differences[k - n] += step;
        differences[wrap(last)] += amount * (last_share - find_inner(end - 1.0));
      } else if (last > first) {
        differences[wrap(last)] += amount * (last_share - first_share);
      }
      differences[wrap(last + 1)] += amount * (1.0 - last_share);
    }
    if (last + 1 < n) return 1.0;
    if (first >= n) return 0.0;
    return last + 1 == n ? last_share : first + 1 == n ? first_share : find_inner(static_cast<double>(n - 1));
  }

  // Share of a parabola that lies before a share of its width.
  static double hold(double share) noexcept { return share < 1.0 ? share * share * (3.0 - 2.0 * share) : 1.0; }
  // The same of one that moves by a path [widths]; 1 once all of it is passed.
  static double hold_moved(double share, double path) noexcept {
    if (share >= 1.0 + path) return 1.0;
    const auto integral = [](double s) { return s <= 0.0 ? 0.0 : s < 1.0 ? s * s * s * (1.0 - 0.5 * s) : s - 0.5; };
    return (integral(share) - integral(share - path)) / path;
  }

  std::vector<double> differences_;
  std::vector<double> cell_amounts_;  // of points and parabolas
  double base_ = 0.0;                 // amount that covers every cell from the seam on
  double cells_per_radian_;
};

}  // namespace gudgeon
