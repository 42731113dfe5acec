// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Points as sums of turned constant vectors, sharing what their paths have in common.
#pragma once

#include <vector>

#include "gudgeon/system/coordinates.h"

namespace gudgeon {

/// Each row is its predecessor's point plus one term; rows stand after their predecessors.
class PointChain {
 public:
  struct Row {
    int predecessor;  ///< row it starts from; -1: the frame's origin
    int turn;
    int slide;
    Vec2 vector;
  };
  struct PointMotion {
    Vec2 position;  ///< [m]
    Vec2 velocity;  ///< [m/s]
    Vec2 arm;       ///< the row's vector, turned
  };

  /// Adds the rows of a path that are not there yet; returns the row of its end. An empty path is given a row too.
  int add(const Path& path, const CoordinateCounts& counts);

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// Positions and velocities of all rows. motions has rows().size() entries.
  void find_motions(const Coordinates& coordinates, PointMotion* motions) const noexcept {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Row& row = rows_[r];
      const Vec2 arm = coordinates.rotation[row.turn] * row.vector;
      const double scale = coordinates.slide[row.slide];
      const double turning = scale * coordinates.angle_rate[row.turn];
      const double sliding = coordinates.slide_rate[row.slide];
      Vec2 position = scale * arm;
      Vec2 velocity{sliding * arm.x - turning * arm.y, sliding * arm.y + turning * arm.x};
      if (row.predecessor >= 0) {
        position += motions[row.predecessor].position;
        velocity += motions[row.predecessor].velocity;
      }
      motions[r] = {position, velocity, arm};
    }
  }

  /// Accelerations of all rows [m/s^2], given their motions and the accelerations of all turns and slides.
  void find_accelerations(const Coordinates& coordinates, const PointMotion* motions, const double* angle_accelerations,
                          const double* slide_accelerations, Vec2* accelerations) const noexcept;

 private:
  std::vector<Row> rows_;
};

}  // namespace gudgeon
