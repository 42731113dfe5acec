// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sums of many arcs laid onto a circumference of equal regions.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gudgeon {

/// Adds constant amounts over arcs in constant time each: only the two ends of an arc are noted, as first differences;
/// sum() integrates them. Parabolas are added region by region. A region that an arc covers in part gets that part, so
/// that what is laid down in all equals mean amount times arc width, to rounding, whatever the number of regions.
class ArcAccumulator {
 public:
  explicit ArcAccumulator(std::size_t n_regions)
      : differences_(n_regions + 2, 0.0),
        region_amounts_(n_regions, 0.0),
        regions_per_radian_(static_cast<double>(n_regions) / (2.0 * std::numbers::pi)) {}

  /// Adds `amount` to every point of the arc of that width [rad] <= 2π centred at `angle` [rad].
  void add_arc(double angle, double width, double amount) noexcept {
    const double n = static_cast<double>(region_amounts_.size());
    const double regions = width * regions_per_radian_;
    double first = angle * regions_per_radian_ - 0.5 * regions;
    first -= n * std::floor(first / n);
    add_edge(first, amount);
    double last = first + regions;
    if (last >= n) {
      // The arc runs over the seam: one full pass begins again at region 0.
      last -= n;
      base_ += amount;
    }
    add_edge(last, -amount);
  }

  /// Adds a parabola that vanishes at both ends of the arc, 3/2 mean_amount (1 − (2x/width)²) at x [rad] from its
  /// centre. Every region gets the exact mean over it: a share u of the width from one end holds u² (3 − 2u) of all.
  void add_parabola(double angle, double width, double mean_amount) noexcept {
    const std::size_t n = region_amounts_.size();
    const double regions = width * regions_per_radian_;
    if (!(regions > 0.0)) return;
    double first = angle * regions_per_radian_ - 0.5 * regions;
    first -= static_cast<double>(n) * std::floor(first / static_cast<double>(n));
    const double all = mean_amount * regions;
    double before = 0.0;
    for (std::size_t k = static_cast<std::size_t>(first); before < 1.0; ++k) {
      const double share = (static_cast<double>(k + 1) - first) / regions;
      const double held = share < 1.0 ? share * share * (3.0 - 2.0 * share) : 1.0;
      region_amounts_[k % n] += all * (held - before);
      before = held;
    }
  }

  /// Adds `amount` to the one region that holds the angle [rad].
  void add_point(double angle, double amount) noexcept {
    const double n = static_cast<double>(region_amounts_.size());
    double position = angle * regions_per_radian_;
    position -= n * std::floor(position / n);
    const std::size_t region = static_cast<std::size_t>(position);
    region_amounts_[region < region_amounts_.size() ? region : 0] += amount;
  }

  /// The mean amount over each region.
  [[nodiscard]] std::vector<double> sum() const {
    std::vector<double> amounts = region_amounts_;
    double level = base_;
    for (std::size_t k = 0; k < amounts.size(); ++k) {
      level += differences_[k];
      amounts[k] += level;
    }
    return amounts;
  }

 private:
  // A step of height `amount` at a position in [0, n]: its region gets the part behind the step.
  void add_edge(double position, double amount) noexcept {
    const double whole = std::floor(position);
    const double part = amount * (position - whole);
    double* at = &differences_[static_cast<std::size_t>(whole)];
    at[0] += amount - part;
    at[1] += part;
  }

  std::vector<double> differences_;
  std::vector<double> region_amounts_;  // of points and parabolas
  double base_ = 0.0;                   // amount that covers every region from the seam on
  double regions_per_radian_;
};

}  // namespace gudgeon
