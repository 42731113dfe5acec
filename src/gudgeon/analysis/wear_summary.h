// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How deep, where and how much the clearance joints have worn.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// A part of the circumference is called worn where its depth exceeds this part of the largest depth: low enough to
/// hold every scar one would see, high enough to leave out the dust of single light impacts.
inline constexpr double kWornFraction = 0.1;

/// A range of angles, counter-clockwise; one that passes 0 ends above 360.
struct AngleRange {
  double begin = 0.0;  ///< [deg] in [0, 360)
  double end = 0.0;    ///< [deg] in (begin, begin + 360]
};

/// A part of one side of a slot.
struct SideRange {
  std::size_t side = 0;  ///< 0 left, 1 right
  double begin = 0.0;    ///< [m] from the middle of the slot
  double end = 0.0;
};

/// Largest value of a depth profile.
struct DeepestPoint {
  double depth = 0.0;       ///< [m]
  double angle = 0.0;       ///< [rad] of the middle of its cell, on a round surface
  double position = 0.0;    ///< [m] of the middle of its cell on a slot's side, from the middle of the slot
  std::size_t surface = 0;  ///< of a slot 0 left, 1 right; of a block its corner
};

/// Wear of one joint up to and with one stage. "Total" depths are bearing and journal together, over the
/// circumference of the bearing or the sides of its slot.
struct JointWearSummary {
  std::string joint;
  DeepestPoint added;        ///< total, by this stage alone
  DeepestPoint accumulated;  ///< total, by this stage and all before it
  DeepestPoint bearing;      ///< accumulated, bearing alone
  DeepestPoint journal;      ///< accumulated, journal alone, angle in the journal's body
  bool is_slot = false;
  double mean_depth_added = 0.0;      ///< [m] of the total over the whole bearing, by this stage
  std::vector<AngleRange> worn;       ///< where the accumulated total exceeds kWornFraction of its largest
  std::vector<SideRange> worn_sides;  ///< the same of a slot
  double removed_volume = 0.0;        ///< [m^3] by this stage
  double archard_volume = 0.0;        ///< [m^3] ∫ k_d F ds of this stage
  double clearance_share = 0.0;       ///< deepest added over the unworn clearance
};

/// A stage that deepens a joint by more than this share of its clearance has been accelerated further than the motion
/// on the surfaces it ran on can tell: the clearance itself is what that motion follows.
inline constexpr double kFarthestExtrapolation = 0.2;

/// The total depth added by the stages 0 … stage_index together, over the bearing's circumference; empty when none
/// has the joint. NumericalError when the stages have different numbers of cells.
std::vector<double> find_accumulated_depth(const RunRecord& run, std::size_t stage_index, const std::string& joint);

/// One summary a clearance joint of that stage.
std::vector<JointWearSummary> summarize_wear(const RunRecord& run, std::size_t stage_index);

/// The ranges where a profile over the circumference exceeds the fraction of its largest value.
std::vector<AngleRange> find_worn_ranges(std::span<const double> depth, double fraction = kWornFraction);

/// The same over the sides of a slot of that length [m]; depth holds the left side, then the right.
std::vector<SideRange> find_worn_sides(std::span<const double> depth, double length, double fraction = kWornFraction);

/// The deepest cell of a circumference; zero depth at angle zero for an empty profile.
DeepestPoint find_deepest(std::span<const double> depth);

}  // namespace gudgeon
