// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The worn surfaces that a run went through, each as depths over its surface coordinate.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Surfaces of one joint at one time.
struct WearState {
  std::string name;                   ///< "first wear"
  std::string stage;                  ///< the stage that ran on them, or after which they are
  std::vector<double> bearing_depth;  ///< [m] a cell
  std::vector<double> journal_depth;  ///< [m]
  std::vector<double> total_depth;    ///< [m] both together, over the bearing's surface
};

/// The worn surfaces that stages ran on. When none ran on worn surfaces, what the last stage leaves.
std::vector<WearState> find_wear_states(const RunRecord& run, const std::string& joint);

/// Depths of one surface: over the angle of a round one, over the place along a flat one.
struct SurfaceProfile {
  std::string name;       ///< "bearing"
  std::string label;      ///< of the coordinate, "Angle in the bearing"
  std::string unit;       ///< of the coordinate, "rad" or "m"
  double radius = 0.0;    ///< [m] of a round surface, unworn; 0 for a flat one
  int part = -1;          ///< which of the sides of a slot or corners of a block; -1 for what is one alone
  double outwards = 1.0;  ///< sign of the depth along the radius: bearings grow, journals shrink
  Numbers position;
  Numbers depth;  ///< [m]
};

/// The bearing's or journal's depths surface by surface; the total lies on the bearing's.
std::vector<SurfaceProfile> split_bearing(const JointWear& wear, const std::vector<double>& depth);
std::vector<SurfaceProfile> split_journal(const JointWear& wear, const std::vector<double>& depth);

}  // namespace gudgeon
