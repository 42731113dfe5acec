// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sharing of path prefixes, and accelerations.
#include "gudgeon/system/point_chain.h"

#include <algorithm>

namespace gudgeon {

int PointChain::add(const Path& path, const CoordinateCounts& counts) {
  int at = -1;
  for (const Term& term : path) {
    const auto same = std::ranges::find_if(rows_, [&](const Row& row) {
      return row.predecessor == at && row.turn == term.turn && row.slide == term.slide && row.vector == term.vector;
    });
    const int found = static_cast<int>(same - rows_.begin());
    if (same == rows_.end()) rows_.push_back({at, term.turn, term.slide, term.vector});
    at = found;
  }
  if (at >= 0) return at;
  rows_.push_back({-1, counts.frame_turn(), counts.unit_slide(), {}});
  return static_cast<int>(rows_.size()) - 1;
}

void PointChain::find_accelerations(const Coordinates& coordinates, const PointMotion* motions,
                                    const double* angle_accelerations, const double* slide_accelerations,
                                    Vec2* accelerations) const noexcept {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row& row = rows_[r];
    const Vec2 arm = motions[r].arm;
    const double scale = coordinates.slide[row.slide];
    const double rate = coordinates.angle_rate[row.turn];
    const double along = slide_accelerations[row.slide] - scale * rate * rate;
    const double across = scale * angle_accelerations[row.turn] + 2.0 * coordinates.slide_rate[row.slide] * rate;
    accelerations[r] = along * arm + across * perp(arm);
    if (row.predecessor >= 0) accelerations[r] += accelerations[row.predecessor];
  }
}

}  // namespace gudgeon
