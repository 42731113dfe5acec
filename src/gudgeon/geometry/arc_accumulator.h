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

  /// Where an arc begins and ends among the regions.
  struct Arc {
    std::size_t first = 0;    ///< region that holds its beginning
    std::size_t last = 0;     ///< and its end
    double first_part = 0.0;  ///< how much of that region lies before the beginning [1]
    double last_part = 0.0;
    bool over_seam = false;  ///< it runs over the seam: one full pass begins again at region 0
  };

  /// The arc of that width [rad] <= 2π centred at `angle` [rad]; the same for all that have as many regions.
  [[nodiscard]] Arc find_arc(double angle, double width) const noexcept {
    const double n = static_cast<double>(region_amounts_.size());
    const double regions = width * regions_per_radian_;
    double first = angle * regions_per_radian_ - 0.5 * regions;
    first -= n * std::floor(first / n);
    double last = first + regions;
    const bool over_seam = last >= n;
    if (over_seam) last -= n;
    const double whole_first = std::floor(first);
    const double whole_last = std::floor(last);
    return {static_cast<std::size_t>(whole_first), static_cast<std::size_t>(whole_last), first - whole_first,
            last - whole_last, over_seam};
  }

  /// Adds `amount` to every point of the arc.
  void add_arc(const Arc& arc, double amount) noexcept {
    add_edge(arc.first, arc.first_part, amount);
    add_edge(arc.last, arc.last_part, -amount);
    if (arc.over_seam) base_ += amount;
  }
  void add_arc(double angle, double width, double amount) noexcept { add_arc(find_arc(angle, width), amount); }

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
  // A step of height `amount` behind that part of a region, which gets what is behind it.
  void add_edge(std::size_t region, double part, double amount) noexcept {
    double* at = &differences_[region];
    at[0] += amount - amount * part;
    at[1] += amount * part;
  }

  std::vector<double> differences_;
  std::vector<double> region_amounts_;  // of points and parabolas
  double base_ = 0.0;                   // amount that covers every region from the seam on
  double regions_per_radian_;
};

}  // namespace gudgeon
