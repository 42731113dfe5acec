// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// History, prediction, and the Hermite polynomial.
#include "gudgeon/sim/singular_passage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace gudgeon {

namespace {

// From this closeness on the equations are avoided; pivots are then two digits smaller than usual.
constexpr double kCloseness = 200.0;
// From this one on, steps are kept to a share of the time left, so that the history is dense where it is needed.
constexpr double kAheadCloseness = 20.0;
// Nodes lie up to three times as far from the singular position as the newest, so at a ninth of its closeness.
constexpr double kRememberedCloseness = 5.0;
constexpr double kStepShare = 0.2;
// Steps kept; enough to reach back over a stride at the tightest tolerances.
constexpr std::size_t kMostEntries = 400;
constexpr std::size_t kPassageNodes = 4;
// The estimate is that of a polynomial two orders lower, which is off by far more than the one that is used.
constexpr double kTrustedEstimate = 100.0;
// Rounding in the slopes grows towards the position while the polynomial's own error shrinks. Where the estimate no
// longer falls from step to step nothing better is to be had, and up to so many times more is then taken.
constexpr double kMostForgiven = 30.0;
// A motion continued from slopes that rounding has moved is never known better than this, relative to its size.
constexpr double kFinestTolerance = 1e-11;

}  // namespace

SingularPassage::SingularPassage(std::size_t n_components, double tolerance)
    : tolerance_(std::max(tolerance, kFinestTolerance)),
      ring_(kMostEntries, {0.0, 0.0, std::vector<double>(n_components), std::vector<double>(n_components)}) {
  nodes_.reserve(kPassageNodes);
}

void SingularPassage::note(double time, const std::vector<double>& y, const std::vector<double>& slope,
                           double closeness) {
  if (!(closeness >= kRememberedCloseness)) {
    forget();
    return;
  }
  newest_ = (newest_ + 1) % ring_.size();
  n_entries_ = std::min(n_entries_ + 1, ring_.size());
  Entry& entry = ring_[newest_];
  entry.time = time;
  entry.distance = 1.0 / std::sqrt(closeness);
  entry.y = y;
  entry.slope = slope;
}

// Time to the singular position if the distance goes on to shrink as over the last step; infinite if it does not.
double SingularPassage::find_time_left() const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (n_entries_ < 2) return kNever;
  const Entry& now = entry(0);
  const Entry& before = entry(1);
  if (now.distance >= before.distance) return kNever;
  return now.distance * (now.time - before.time) / (before.distance - now.distance);
}

double SingularPassage::find_longest_step() const {
  if (n_entries_ == 0 || entry(0).distance * entry(0).distance * kAheadCloseness > 1.0) {
    return std::numeric_limits<double>::infinity();
  }
  return kStepShare * find_time_left();
}

std::optional<double> SingularPassage::find_far_side() {
  if (n_entries_ < kPassageNodes) return std::nullopt;
  const Entry& now = entry(0);
  const double stride = 2.0 * find_time_left();
  if (now.distance * now.distance * kCloseness > 1.0 || !std::isfinite(stride)) return std::nullopt;
  choose_nodes(stride);
  if (nodes_.size() < kPassageNodes) return std::nullopt;
  // The polynomial through one step less tells how far this one is to be trusted.
  const double far_side = now.time + stride;
  double worst = 0.0;
  for (std::size_t i = 0; i < now.y.size(); ++i) {
    const double error = extrapolate(far_side, i, kPassageNodes) - extrapolate(far_side, i, kPassageNodes - 1);
    const double ratio = std::abs(error) / (kTrustedEstimate * tolerance_ * std::max(1.0, std::abs(now.y[i])));
    worst = ratio <= worst ? worst : std::isfinite(ratio) ? ratio : kNothingKnown;
  }
  const double last_worst = std::exchange(last_worst_, worst);
  if (worst <= 1.0 || (worst >= last_worst && worst <= kMostForgiven)) return far_side;
  return std::nullopt;
}

// The newest step and three before it, each at least a third of the stride from the next.
void SingularPassage::choose_nodes(double stride) {
  nodes_.clear();
  for (std::size_t back = 0; back < n_entries_ && nodes_.size() < kPassageNodes; ++back) {
    if (nodes_.empty() || nodes_.back()->time - entry(back).time >= stride / 3.0) nodes_.push_back(&entry(back));
  }
}

// Newton's divided differences with every node doubled, so that slopes are met as well as values.
double SingularPassage::extrapolate(double time, std::size_t component, std::size_t n_nodes) const {
  std::array<double, 2 * kPassageNodes> at{};
  std::array<double, 2 * kPassageNodes> difference{};
  const std::size_t n = 2 * n_nodes;
  for (std::size_t k = 0; k < n; ++k) {
    at[k] = nodes_[k / 2]->time;
    difference[k] = nodes_[k / 2]->y[component];
  }
  for (std::size_t order = 1; order < n; ++order) {
    for (std::size_t k = n - 1; k >= order; --k) {
      const bool same_node = order == 1 && k % 2 == 1;
      difference[k] =
          same_node ? nodes_[k / 2]->slope[component] : (difference[k] - difference[k - 1]) / (at[k] - at[k - order]);
    }
  }
  double value = difference[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) value = value * (time - at[k]) + difference[k];
  return value;
}

void SingularPassage::interpolate(double time, std::vector<double>& y) const {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = extrapolate(time, i, kPassageNodes);
}

// Of the ring, what is still looked back to.
void SingularPassage::transfer(StateArchive& archive) {
  archive(newest_, n_entries_, last_worst_);
  std::array<std::size_t, kPassageNodes> nodes{};
  std::size_t n_nodes = nodes_.size();
  for (std::size_t k = 0; k < n_nodes; ++k) nodes[k] = static_cast<std::size_t>(nodes_[k] - ring_.data());
  archive(n_nodes, nodes);
  if (newest_ >= ring_.size() || n_nodes > kPassageNodes) StateArchive::refuse();
  for (std::size_t k = 0; k < ring_.size(); ++k) {
    bool is_used = (newest_ + ring_.size() - k) % ring_.size() < n_entries_;
    for (std::size_t node = 0; node < n_nodes; ++node) is_used = is_used || nodes[node] == k;
    if (is_used) archive(ring_[k]);
  }
  if (!archive.is_loading()) return;
  nodes_.clear();
  for (std::size_t k = 0; k < n_nodes; ++k) nodes_.push_back(&ring_.at(nodes.at(k)));
}

}  // namespace gudgeon
